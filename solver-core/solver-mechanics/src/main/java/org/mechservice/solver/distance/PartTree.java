package org.mechservice.solver.distance;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/** The parts of a body in balls within balls, two in each, down to a part alone. */
final class PartTree {
  final double[] centre = new double[3];
  final double radius;
  final Optional<SolidPart> part;
  private final List<PartTree> halves;

  private PartTree(SolidPart part) {
    this.part = Optional.of(part);
    System.arraycopy(part.centre(), 0, centre, 0, 3);
    radius = part.radius();
    halves = List.of();
  }

  private PartTree(PartTree one, PartTree other) {
    part = Optional.empty();
    halves = List.of(one, other);
    double farthest = 0;
    for (int i = 0; i < 3; i++) {
      centre[i] = 0.5 * (one.centre[i] + other.centre[i]);
    }
    for (PartTree half : halves) {
      double square = 0;
      for (int i = 0; i < 3; i++) {
        double d = half.centre[i] - centre[i];
        square += d * d;
      }
      farthest = Math.max(farthest, Math.sqrt(square) + half.radius);
    }
    radius = farthest;
  }

  static PartTree of(List<SolidPart> parts) {
    if (parts.size() == 1) {
      return new PartTree(parts.get(0));
    }
    double[] least = parts.get(0).centre().clone();
    double[] most = least.clone();
    for (SolidPart part : parts) {
      for (int i = 0; i < 3; i++) {
        least[i] = Math.min(least[i], part.centre()[i]);
        most[i] = Math.max(most[i], part.centre()[i]);
      }
    }
    int axis = 0;
    for (int i = 1; i < 3; i++) {
      axis = most[i] - least[i] > most[axis] - least[axis] ? i : axis;
    }
    int along = axis;
    List<SolidPart> sorted = new ArrayList<>(parts);
    sorted.sort(Comparator.comparingDouble(part -> part.centre()[along]));
    int half = sorted.size() / 2;
    return new PartTree(of(sorted.subList(0, half)), of(sorted.subList(half, sorted.size())));
  }

  /** Returns the two halves; none of a part alone. */
  List<PartTree> halves() {
    return halves;
  }
}
