package org.mechservice.admin.watch;

import java.util.Comparator;
import java.util.List;
import org.mechservice.admin.KnownSimulation;

/** The sort order of simulations. */
enum SortOrder {
  AGE("age"),
  STATE("state"),
  MODEL("model"),
  OWNER("owner"),
  HOST("host"),
  PROGRESS("progress"),
  SPEED("speed");

  private static final List<SortOrder> ALL = List.of(values());

  private final String label;

  SortOrder(String label) {
    this.label = label;
  }

  String label() {
    return label;
  }

  /** Returns the order; equal entries are ordered by id, so that no row jumps. */
  Comparator<KnownSimulation> order(boolean reversed) {
    Comparator<KnownSimulation> order = order().thenComparing(known -> known.summary().simId);
    return reversed ? order.reversed() : order;
  }

  private Comparator<KnownSimulation> order() {
    return switch (this) {
      case AGE -> Comparator.comparingLong(known -> -known.summary().createdAt);
      case STATE -> Comparator.comparing(KnownSimulation::state);
      case MODEL -> Comparator.comparing(known -> known.summary().modelName);
      case OWNER -> Comparator.comparing(known -> known.summary().owner);
      case HOST -> Comparator.comparing(known -> known.summary().hostName);
      case PROGRESS -> Comparator.comparingDouble(known -> -known.progress());
      case SPEED -> Comparator.comparingDouble(known -> -known.summary().info.realTimeFactor);
    };
  }

  SortOrder next() {
    return ALL.get((ALL.indexOf(this) + 1) % ALL.size());
  }
}
