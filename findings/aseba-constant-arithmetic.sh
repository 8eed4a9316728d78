#!/bin/bash
# Aseba: the same product gives another result when a variable takes the place of a number.
#
# Guess before the first run: 1000 * 50 / 100 is the same for three numbers and for variables with their values: 500, or what 16 bits wrap to.
# Seen: 500 for numbers, which the compiler multiplies in wider integers; -155 for variables, which wrap at 16 bits. No
# message says so.
set -euo pipefail
dir=$(mktemp -d) && trap 'rm -rf "$dir"' EXIT && cd "$dir"

# Packages of Debian 12 as root/, without installing them; of the libraries only those that this system lacks.
fetch() {
    local lib
    for lib in; do
        dpkg-query -W -f '${Status}' "$lib" 2>/dev/null | grep -q 'ok installed' || set -- "$@" "$lib"
    done
    apt-get download -qq "$@" 2>/dev/null
    for lib in *.deb; do dpkg -x "$lib" root; done
    LD_LIBRARY_PATH=$(find "$dir/root" -name '*.so*' -printf '%h\n' | sort -u | paste -sd:)
    export LD_LIBRARY_PATH
}

# expect WHAT SEEN WANTED: a difference means that the behaviour has changed.
expect() {
    printf '%-58s %s\n' "$1" "$2"
    [ "$2" = "$3" ] || { echo "changed: it was $3"; exit 1; }
}

fetch aseba=1.6.99+dfsg-7
echo "aseba 1.6.99+dfsg-7"
mkdir locales && localedef -i en_US -f UTF-8 locales/en_US.UTF-8 2>/dev/null || true  # the compiler asks for it
cat > run.cpp <<'CODE'
#include <clocale>
#include <cstdio>
#include <sstream>
#include <vector>
#define ASEBA_ASSERT
#include "common/consts.h"
#include "compiler/compiler.h"
#include "vm/natives.h"
#include "vm/vm.h"
extern "C" {
void AsebaSendMessage(AsebaVMState*, uint16_t, const void*, uint16_t) {}
void AsebaSendVariables(AsebaVMState*, uint16_t, uint16_t) {}
void AsebaSendDescription(AsebaVMState*) {}
void AsebaNativeFunction(AsebaVMState*, uint16_t) {}
void AsebaWriteBytecode(AsebaVMState*) {}
void AsebaResetIntoBootloader(AsebaVMState*) {}
void AsebaPutVmToSleep(AsebaVMState*) {}
void AsebaAssert(AsebaVMState*, AsebaAssertReason) {}
void AsebaVMErrorCB(AsebaVMState*, const char*) {}
}
int main() {
    std::setlocale(LC_ALL, "C.UTF-8");
    Aseba::TargetDescription target;
    target.name = L"robot", target.protocolVersion = 5;
    target.bytecodeSize = 256, target.variablesSize = 64, target.stackSize = 32;
    target.namedVariables = {{L"numbers", 1}, {L"variables", 1}};
    const Aseba::CommonDefinitions none;
    Aseba::Compiler compiler;
    compiler.setTargetDescription(&target), compiler.setCommonDefinitions(&none);
    std::wistringstream program(
        L"var a = 1000\nvar b = 50\nnumbers = 1000 * 50 / 100\nvariables = a * b / 100\n");
    Aseba::BytecodeVector code;
    unsigned used = 0;
    Aseba::Error error;
    if (!compiler.compile(program, code, used, error)) return 2;
    std::vector<uint16_t> words(256);
    std::vector<int16_t> values(64), stack(32);
    AsebaVMState vm{};
    vm.nodeId = 1, vm.bytecodeSize = 256, vm.bytecode = words.data();
    vm.variablesSize = 64, vm.variables = values.data(), vm.stackSize = 32, vm.stack = stack.data();
    AsebaVMInit(&vm);
    for (std::size_t i = 0; i < code.size(); ++i) words[i] = code[i].bytecode;
    vm.flags = 0;
    AsebaVMSetupEvent(&vm, ASEBA_EVENT_INIT);
    while (AsebaMaskIsSet(vm.flags, ASEBA_VM_EVENT_ACTIVE_MASK) && AsebaVMRun(&vm, 60000) != 0) {}
    std::printf("%d %d\n", values[0], values[1]);
}
CODE
libs=$(dirname "$(find root -name 'libasebacompiler*' | head -1)")
g++ -std=c++17 -O0 -I root/usr/include/aseba run.cpp -o run -L "$libs" -lasebacompiler -lasebavm -lasebacommon
read -r numbers variables < <(LOCPATH=$dir/locales ./run)
expect "1000 * 50 / 100" "$numbers" 500
expect "a * b / 100 with a = 1000, b = 50" "$variables" -155
