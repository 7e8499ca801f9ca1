package org.mechservice.solver.compact;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.RunSettings;
import org.mechservice.solver.api.WatchedModel;
import org.mechservice.solver.dynamics.StateEvents;
import org.mechservice.solver.force.UserForceSource;
import org.mechservice.solver.mechanism.Mechanism;

/**
 * A model whose class carries data: the mechanism and how its equations are written, as texts that
 * fit into a class file.
 *
 * @param mechanism the mechanism
 * @param formulation {@code DTR}, {@code DSR}, {@code RR} or {@code RR-JF}
 * @param closure {@code none}, {@code projection} or {@code penalty}
 * @param settings the settings the model carries
 */
public record CompactModel(
    Mechanism mechanism, String formulation, String closure, RunSettings settings) {
  /** A text constant of a class file holds 65535 bytes; a character takes one or two. */
  private static final int LONGEST_TEXT = 32_000;

  /** Returns the model as texts. */
  public List<String> texts() {
    byte[] head = new RecordWriter().write(formulation).write(closure).write(settings).bytes();
    byte[] body = CompactForm.write(mechanism);
    String all =
        Character.toString(head.length >>> 8)
            + (char) (head.length & 0xff)
            + new String(head, StandardCharsets.ISO_8859_1)
            + new String(body, StandardCharsets.ISO_8859_1);
    List<String> texts = new ArrayList<>();
    for (int at = 0; at < all.length(); at += LONGEST_TEXT) {
      texts.add(all.substring(at, Math.min(all.length(), at + LONGEST_TEXT)));
    }
    return texts;
  }

  /**
   * Returns the model that texts stand for.
   *
   * @param texts what {@link #texts} returned
   * @throws IllegalArgumentException S-067 if they are damaged or of another version
   */
  public static CompactModel of(List<String> texts) {
    String all = String.join("", texts);
    int head = all.length() < 2 ? 0 : (all.charAt(0) << 8) + all.charAt(1);
    if (head == 0 || all.length() < 2 + head) {
      throw new IllegalArgumentException(
          "S-067 the model's data are damaged or of another version; build it anew");
    }
    RecordReader reader = new RecordReader(bytes(all.substring(2, 2 + head)));
    return new CompactModel(
        CompactForm.read(bytes(all.substring(2 + head))),
        (String) reader.read(),
        (String) reader.read(),
        (RunSettings) reader.read());
  }

  private static byte[] bytes(String text) {
    return text.getBytes(StandardCharsets.ISO_8859_1);
  }

  /**
   * Makes the model of a compact class.
   *
   * @param loader finds the classes of user forces
   * @param texts what {@link #texts} returned
   */
  public static Model model(ClassLoader loader, String... texts) {
    return of(List.of(texts)).model(new LoadedUserForces(loader));
  }

  /**
   * Returns the equations of motion, driven by the data.
   *
   * @param userForces makes the forces that users have written
   * @throws IllegalArgumentException if the formulation or the closure does not suit the mechanism
   */
  public Model model(UserForceSource userForces) {
    Model model = DataDriven.model(this, userForces);
    return somethingHappens() ? new WatchedModel(model, new StateEvents(mechanism)) : model;
  }

  private boolean somethingHappens() {
    return !mechanism.events().isEmpty()
        || !mechanism.timeJumps(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY).isEmpty();
  }
}
