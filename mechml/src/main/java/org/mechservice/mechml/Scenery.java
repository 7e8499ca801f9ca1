package org.mechservice.mechml;

import java.util.List;
import java.util.Map;

/**
 * What a model file says for the eye beside the mechanism, by the names of its elements.
 *
 * @param solids what the bodies consist of, in file order
 * @param looks what the bodies are shown as, in file order
 * @param routes what ropes, cables and muscles pass
 * @param roads the surfaces of contacts and tyres whose height changes
 */
public record Scenery(
    Map<String, List<Solid>> solids,
    Map<String, List<Look>> looks,
    Map<String, Route> routes,
    Map<String, Road> roads) {
  /** Nothing but the mechanism. */
  public static final Scenery NONE = new Scenery(Map.of(), Map.of(), Map.of(), Map.of());

  public Scenery {
    solids = Map.copyOf(solids);
    looks = Map.copyOf(looks);
    routes = Map.copyOf(routes);
    roads = Map.copyOf(roads);
  }
}
