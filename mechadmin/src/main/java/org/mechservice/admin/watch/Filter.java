package org.mechservice.admin.watch;

import java.util.List;
import org.mechservice.admin.KnownSimulation;

/** Which simulations are listed. */
enum Filter {
  GOING_ON("going on"),
  FAILED("failed"),
  ALL("all");

  private static final List<Filter> EVERY = List.of(values());

  private final String label;

  Filter(String label) {
    this.label = label;
  }

  String label() {
    return label;
  }

  boolean accepts(KnownSimulation known) {
    return switch (this) {
      case GOING_ON -> known.isUnfinished();
      case FAILED -> known.state().equals("failed");
      case ALL -> true;
    };
  }

  Filter next() {
    return EVERY.get((EVERY.indexOf(this) + 1) % EVERY.size());
  }
}
