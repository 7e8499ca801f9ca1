package org.mechservice.solver.scenes;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.oracle.OracleForce;

/**
 * A scene with its reference solution.
 *
 * @param mechanism what moves
 * @param forces its forces once more, for the oracle
 * @param end end of the interval, s
 * @param reference states at the output times, the start among them; empty if there are none
 */
public record SharedScene(
    Mechanism mechanism, List<OracleForce> forces, double end, List<ReferenceState> reference) {

  /**
   * A state of the reference solution.
   *
   * @param t time, s
   * @param q positions
   * @param v velocities
   * @param a accelerations; empty if not given
   */
  @SuppressWarnings("ArrayRecordComponent") // handed to routines that take arrays
  public record ReferenceState(double t, double[] q, double[] v, double[] a) {}

  /** Reads a scene by the name of its file. */
  public static SharedScene named(String name) {
    JsonObject scene = json(name + ".json");
    JsonSceneReader reader = new JsonSceneReader(scene);
    List<ReferenceState> states = new ArrayList<>();
    if (SharedScene.class.getResource(name + ".ref.json") != null) {
      for (var row : json(name + ".ref.json").getAsJsonArray("out")) {
        JsonObject out = row.getAsJsonObject();
        states.add(
            new ReferenceState(
                out.get("t").getAsDouble(),
                JsonSceneReader.numbers(out, "q"),
                JsonSceneReader.numbers(out, "v"),
                out.has("a") ? JsonSceneReader.numbers(out, "a") : new double[0]));
      }
    }
    return new SharedScene(
        reader.mechanism(), reader.oracleForces(), scene.get("tend").getAsDouble(), states);
  }

  private static JsonObject json(String file) {
    try (InputStream in = SharedScene.class.getResourceAsStream(file)) {
      if (in == null) {
        throw new IllegalArgumentException("there is no scene " + file);
      }
      return JsonParser.parseReader(new InputStreamReader(in, StandardCharsets.UTF_8))
          .getAsJsonObject();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
