package org.mechservice.mechml.resolve;

import java.util.List;

/**
 * A joint's coordinates at the start, in SI and in the order of its type.
 *
 * @param positions q
 * @param velocities v
 */
record StartValues(List<Double> positions, List<Double> velocities) {
  StartValues {
    positions = List.copyOf(positions);
    velocities = List.copyOf(velocities);
  }

  double position(int index) {
    return positions.get(index);
  }

  double velocity(int index) {
    return velocities.get(index);
  }
}
