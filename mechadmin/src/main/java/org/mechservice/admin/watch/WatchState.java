package org.mechservice.admin.watch;

import java.util.List;
import java.util.Optional;
import org.mechservice.admin.KnownSimulation;
import org.mechservice.admin.ServerReading;

/**
 * The selection of the operator in the full screen: keys change it, the screen shows it. The choice
 * stays with its simulation when others come and go.
 */
final class WatchState {
  /** An action of a key that concerns more than the screen. */
  enum Wish {
    NOTHING,
    INSPECT,
    CANCEL,
    QUIT
  }

  private static final int PAGE = 10;

  private SortOrder sort = SortOrder.AGE;
  private boolean reversed;
  private Filter filter = Filter.GOING_ON;
  private String chosen = "";
  private int place;
  private boolean asking;
  private Optional<List<String>> detail = Optional.empty();
  private int scrolled;
  private String news = "";

  SortOrder sort() {
    return sort;
  }

  Filter filter() {
    return filter;
  }

  /** Returns whether the operator has to confirm that a simulation is cancelled. */
  boolean asking() {
    return asking;
  }

  /** Returns the result of the last action. */
  String news() {
    return news;
  }

  void notice(String text) {
    news = text;
  }

  /** Shows a simulation in full. */
  void show(String text) {
    detail = Optional.of(text.lines().toList());
    scrolled = 0;
  }

  /** Returns the lines of the simulation that is shown in full, from where it is scrolled to. */
  Optional<List<String>> detail() {
    return detail.map(lines -> lines.subList(Math.min(scrolled, lines.size()), lines.size()));
  }

  /** Returns the simulations listed, in order. */
  List<KnownSimulation> listed(List<ServerReading> readings) {
    return KnownSimulation.all(readings).stream()
        .filter(filter::accepts)
        .sorted(sort.order(reversed))
        .toList();
  }

  /** Returns the place of the chosen simulation in the list; when it has gone, of its neighbour. */
  int place(List<KnownSimulation> listed) {
    for (int i = 0; i < listed.size(); i++) {
      if (listed.get(i).summary().simId.equals(chosen)) {
        place = i;
        return i;
      }
    }
    place = Math.max(0, Math.min(place, listed.size() - 1));
    return place;
  }

  /** Returns the chosen simulation. */
  Optional<KnownSimulation> chosen(List<KnownSimulation> listed) {
    return listed.isEmpty() ? Optional.empty() : Optional.of(listed.get(place(listed)));
  }

  /**
   * Follows a key.
   *
   * @param listed the simulations listed
   * @return the action to carry out
   */
  Wish press(WatchKey key, List<KnownSimulation> listed) {
    if (asking) {
      asking = false;
      return key == WatchKey.YES ? Wish.CANCEL : Wish.NOTHING;
    } else if (detail.isPresent()) {
      return inDetail(key);
    }
    news = "";
    return inList(key, listed);
  }

  private Wish inDetail(WatchKey key) {
    int longest = detail.map(List::size).orElse(0);
    switch (key) {
      case UP -> scrolled = Math.max(0, scrolled - 1);
      case DOWN -> scrolled = Math.min(longest, scrolled + 1);
      case PAGE_UP -> scrolled = Math.max(0, scrolled - PAGE);
      case PAGE_DOWN -> scrolled = Math.min(longest, scrolled + PAGE);
      case FIRST -> scrolled = 0;
      case BACK, QUIT, INSPECT -> detail = Optional.empty();
      default -> {
        // Nothing else is offered here.
      }
    }
    return Wish.NOTHING;
  }

  private Wish inList(WatchKey key, List<KnownSimulation> listed) {
    switch (key) {
      case UP -> choose(listed, -1);
      case DOWN -> choose(listed, 1);
      case PAGE_UP -> choose(listed, -PAGE);
      case PAGE_DOWN -> choose(listed, PAGE);
      case FIRST -> choose(listed, -listed.size());
      case LAST -> choose(listed, listed.size());
      case SORT -> sort = sort.next();
      case REVERSE -> reversed = !reversed;
      case FILTER -> filter = filter.next();
      case INSPECT -> {
        return keep(listed) ? Wish.INSPECT : Wish.NOTHING;
      }
      case CANCEL ->
          asking = keep(listed) && chosen(listed).filter(KnownSimulation::isUnfinished).isPresent();
      case QUIT -> {
        return Wish.QUIT;
      }
      default -> {
        // Nothing else is offered here.
      }
    }
    return Wish.NOTHING;
  }

  private void choose(List<KnownSimulation> listed, int by) {
    if (!listed.isEmpty()) {
      place = Math.max(0, Math.min(listed.size() - 1, place(listed) + by));
      chosen = listed.get(place).summary().simId;
    }
  }

  /** Keeps the selection for a confirmation or a detail view while rows come and go. */
  private boolean keep(List<KnownSimulation> listed) {
    choose(listed, 0);
    return !listed.isEmpty();
  }
}
