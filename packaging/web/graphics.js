"use strict";
// Dear ImGui asks for some values of the WebGL context in each frame. The browser answers after it has drawn all that was
// asked for before, which takes as long as a frame in software drawing. These values are kept here as they are set.
// `renderer`: the name of the renderer for the program, which draws in another way with SwiftShader; or empty.

function keepValues(context, renderer) {
    const kept = new Map();
    const keep = (name, value) => kept.set(context[name], value);
    if (renderer) keep("RENDERER", renderer);
    const scissor = ["SCISSOR_BOX"];
    const factors = ["BLEND_SRC_RGB", "BLEND_DST_RGB", "BLEND_SRC_ALPHA", "BLEND_DST_ALPHA"];
    const equations = ["BLEND_EQUATION_RGB", "BLEND_EQUATION_ALPHA"];

    const real = context.getParameter.bind(context);
    for (const name of [...scissor, ...factors, ...equations]) keep(name, real(context[name]));
    context.getParameter = (name) => (kept.has(name) ? kept.get(name) : real(name));

    // Calls the method of the context and keeps the values that `valuesOf` makes of its arguments.
    const follow = (method, names, valuesOf) => {
        const set = context[method].bind(context);
        context[method] = (...given) => {
            set(...given);
            valuesOf(...given).forEach((value, i) => keep(names[i], value));
        };
    };
    follow("scissor", scissor, (...box) => [Int32Array.from(box)]);
    follow("blendFunc", factors, (from, to) => [from, to, from, to]);
    follow("blendFuncSeparate", factors, (...given) => given);
    follow("blendEquation", equations, (equation) => [equation, equation]);
    follow("blendEquationSeparate", equations, (...given) => given);
}
