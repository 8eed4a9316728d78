// Compiles an Aseba program with Aseba's compiler for a Thymio II and runs it in Aseba's virtual machine. Usage:
//
//     aseba_run PROGRAM < lines
//
// Each line: the seven horizontal proximity values and the two of the ground, after which the event `prox` runs; or
// "forward" or "centre", which presses that button. Prints the number of words of the program, then per line of values
// the targets of both motors.
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <locale>
#include <sstream>
#include <string>
#include <vector>

#define ASEBA_ASSERT  // as Debian builds the library
#include "common/consts.h"
#include "compiler/compiler.h"
#include "vm/natives.h"
#include "vm/vm.h"

namespace {

struct Native {
    const AsebaNativeFunctionDescription* description;
    AsebaNativeFunctionPointer function;
};
const Native natives[] = {
    {&AsebaNativeDescription_mathmuldiv, AsebaNative_mathmuldiv},
    {&AsebaNativeDescription_vecmin, AsebaNative_vecmin},
    {&AsebaNativeDescription_vecmax, AsebaNative_vecmax},
};

std::wstring wide(const char* text) { return {text, text + std::char_traits<char>::length(text)}; }

// Sizes of a Thymio II. Of its variables those that programs use, and the space of the others.
Aseba::TargetDescription thymio() {
    Aseba::TargetDescription target;
    target.name = L"thymio-II";
    target.protocolVersion = 5;
    target.bytecodeSize = 1536;
    target.variablesSize = 620;
    target.stackSize = 32;
    target.namedVariables = {{L"_id", 1},
                             {L"event.source", 1},
                             {L"event.args", 32},
                             {L"_others", 94},
                             {L"prox.horizontal", 7},
                             {L"prox.ground.ambiant", 2},
                             {L"prox.ground.reflected", 2},
                             {L"prox.ground.delta", 2},
                             {L"motor.left.target", 1},
                             {L"motor.right.target", 1}};
    for (const wchar_t* event : {L"button.backward", L"button.left", L"button.center", L"button.forward",
                                 L"button.right", L"buttons", L"prox"})
        target.localEvents.push_back({event, L""});
    for (const Native& native : natives) {
        Aseba::TargetDescription::NativeFunction function{wide(native.description->name), L"", {}};
        for (const AsebaNativeFunctionArgumentDescription* a = native.description->arguments; a->size != 0; ++a)
            function.parameters.emplace_back(wide(a->name), a->size);
        target.nativeFunctions.push_back(function);
    }
    return target;
}

bool failed = false;

}  // namespace

extern "C" {
void AsebaSendMessage(AsebaVMState*, uint16_t, const void*, uint16_t) {}
void AsebaSendVariables(AsebaVMState*, uint16_t, uint16_t) {}
void AsebaSendDescription(AsebaVMState*) {}
void AsebaNativeFunction(AsebaVMState* vm, uint16_t id) { natives[id].function(vm); }
void AsebaWriteBytecode(AsebaVMState*) {}
void AsebaResetIntoBootloader(AsebaVMState*) {}
void AsebaPutVmToSleep(AsebaVMState*) {}
void AsebaAssert(AsebaVMState*, AsebaAssertReason reason) {
    std::fprintf(stderr, "the virtual machine stopped: reason %d\n", static_cast<int>(reason));
    std::exit(1);
}
void AsebaVMErrorCB(AsebaVMState*, const char* message) {
    std::fprintf(stderr, "the virtual machine stopped: %s\n", message ? message : "array index or division by zero");
    failed = true;
}
}

int main(int argc, char** argv) {
    if (argc < 2) return 2;
    std::setlocale(LC_ALL, "C.UTF-8");
    std::wifstream source(argv[1]);
    source.imbue(std::locale("C.UTF-8"));
    const Aseba::TargetDescription target = thymio();
    const Aseba::CommonDefinitions none;
    Aseba::Compiler compiler;
    compiler.setTargetDescription(&target);
    compiler.setCommonDefinitions(&none);
    Aseba::BytecodeVector bytecode;
    unsigned variables_used = 0;
    Aseba::Error error;
    if (!compiler.compile(source, bytecode, variables_used, error)) {
        std::wcerr << error.toWString() << std::endl;
        return 1;
    }
    std::vector<uint16_t> words(target.bytecodeSize);
    std::vector<int16_t> variables(target.variablesSize), stack(target.stackSize);
    AsebaVMState vm{};
    vm.nodeId = 1;
    vm.bytecodeSize = target.bytecodeSize, vm.bytecode = words.data();
    vm.variablesSize = target.variablesSize, vm.variables = variables.data();
    vm.stackSize = target.stackSize, vm.stack = stack.data();
    AsebaVMInit(&vm);  // clears the bytecode
    for (std::size_t i = 0; i < bytecode.size(); ++i) words[i] = bytecode[i].bytecode;
    vm.flags = 0;  // AsebaVMInit() sets single-step mode
    const auto run = [&](uint16_t event) {
        AsebaVMSetupEvent(&vm, event);
        while (AsebaMaskIsSet(vm.flags, ASEBA_VM_EVENT_ACTIVE_MASK) && !failed)
            if (AsebaVMRun(&vm, 60000) == 0) break;
    };
    run(ASEBA_EVENT_INIT);
    std::printf("%zu\n", bytecode.size());
    std::fflush(stdout);
    unsigned first_free = 0;
    const Aseba::VariablesMap map = target.getVariablesMap(first_free);
    const auto at = [&](const wchar_t* name) { return &variables[map.at(name).first]; };
    std::string line;
    while (!failed && std::getline(std::cin, line)) {
        if (line == "forward" || line == "centre") {
            run(ASEBA_EVENT_LOCAL_EVENTS_START - (line == "forward" ? 3 : 2));
            continue;
        }
        std::istringstream values(line);
        for (int i = 0; i < 7; ++i) values >> at(L"prox.horizontal")[i];
        for (int i = 0; i < 2; ++i) values >> at(L"prox.ground.reflected")[i];
        run(ASEBA_EVENT_LOCAL_EVENTS_START - 6);  // prox
        std::printf("%d %d\n", *at(L"motor.left.target"), *at(L"motor.right.target"));
        std::fflush(stdout);
    }
    return failed ? 1 : 0;
}
