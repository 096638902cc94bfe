#include <pilotage/engine/engine.hpp>

int main() {
    return 0;
}
