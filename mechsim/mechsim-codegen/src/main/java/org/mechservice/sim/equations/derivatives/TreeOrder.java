package org.mechservice.sim.equations.derivatives;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.mechservice.solver.dynamics.tree.TreePattern;
import org.mechservice.solver.links.Link;
import org.mechservice.solver.links.Links;

/** The velocities of the state from the root outwards: the places of a {@link TreePattern}. */
final class TreeOrder {
  /**
   * A place.
   *
   * @param link the link
   * @param component index among its degrees of freedom, as in the state
   * @param velocity index of the velocity in v
   * @param parent the parent place; −1 for none
   */
  record Place(int link, int component, int velocity, int parent) {}

  private static final int NONE = -1;

  private final List<Place> places = new ArrayList<>();
  private final int[] firstOf;

  TreeOrder(Links mechanism) {
    List<Link> links = mechanism.links();
    firstOf = new int[links.size()];
    int[] last = new int[links.size()];
    for (int i = 0; i < links.size(); i++) {
      Link link = links.get(i);
      int above = link.parent() == Links.ROOT ? NONE : last[link.parent()];
      firstOf[i] = places.size();
      int count = link.isDriven() ? 0 : link.kind().velocityCount();
      for (int c = 0; c < count; c++) {
        int velocity = link.velocity() + c - mechanism.positionCount();
        places.add(new Place(i, c, velocity, c == 0 ? above : places.size() - 1));
      }
      last[i] = count == 0 ? above : places.size() - 1;
    }
  }

  int size() {
    return places.size();
  }

  Place get(int place) {
    return places.get(place);
  }

  /** Returns the places of a link, in order. */
  int[] of(int link) {
    int end = link + 1 < firstOf.length ? firstOf[link + 1] : places.size();
    return IntStream.range(firstOf[link], end).toArray();
  }

  /** Returns whether a place is equal to another or its ancestor. */
  boolean isOnWay(int place, int from) {
    int at = from;
    while (at > place) {
      at = places.get(at).parent();
    }
    return at == place;
  }

  /** Returns the pattern of matrices over the velocities. */
  TreePattern pattern(List<Integer> coupled) {
    return new TreePattern(
        places.stream().mapToInt(Place::velocity).toArray(),
        places.stream().mapToInt(Place::parent).toArray(),
        coupled.stream().mapToInt(Integer::intValue).toArray());
  }

  /** Returns velocity and parent of each place, separated by blanks. */
  String text() {
    return places.stream()
        .map(place -> place.velocity() + " " + place.parent())
        .collect(Collectors.joining(" "));
  }
}
