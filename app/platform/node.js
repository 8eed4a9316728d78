// Of braitenctl under node: the program gets the environment of the process.
Module["preRun"] = () => Object.assign(ENV, process.env);
