#include <pilotage/angle.hpp>

int main() {
    return pilotage::wrap(7.0) < pilotage::kPi<double> ? 0 : 1;
}
