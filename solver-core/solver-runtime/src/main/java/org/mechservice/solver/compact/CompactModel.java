package org.mechservice.solver.compact;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.TunableParameter;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.Formulation;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.dynamics.event.StateEvents;
import org.mechservice.solver.dynamics.event.WrittenValues;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Output;
import org.mechservice.solver.mechanism.Parameter;

/**
 * A model whose class contains data: the mechanism and the names of formulation and closure, as
 * texts that fit into a class file.
 *
 * @param mechanism the mechanism
 * @param formulation {@code DTR}, {@code DSR}, {@code RR} or {@code RR-JF}
 * @param closure {@code none}, {@code projection} or {@code penalty}
 * @param settings default settings of the model
 * @param outputs user-defined output columns
 * @param start the closed start of a large mechanism with loops, for {@link DataDrivenLoops}; its
 *     class is not named here, because models of trees travel without it
 */
public record CompactModel(
    Mechanism mechanism,
    String formulation,
    String closure,
    RunSettings settings,
    List<Output> outputs,
    Optional<Record> start) {
  /** A text constant of a class file holds 65535 bytes; a character takes one or two. */
  private static final int LONGEST_TEXT = 32_000;

  /** Number of leading characters with the length of the head. */
  private static final int HEAD = 3;

  public CompactModel {
    outputs = List.copyOf(outputs);
  }

  /** Creates a model without user-defined outputs. */
  public CompactModel(
      Mechanism mechanism, String formulation, String closure, RunSettings settings) {
    this(mechanism, formulation, closure, settings, List.of());
  }

  /** Creates a model whose loops, if it has some, are closed when it is made. */
  public CompactModel(
      Mechanism mechanism,
      String formulation,
      String closure,
      RunSettings settings,
      List<Output> outputs) {
    this(mechanism, formulation, closure, settings, outputs, Optional.empty());
  }

  /** Returns the model as texts. */
  public List<String> texts() {
    RecordWriter first =
        new RecordWriter().write(formulation).write(closure).write(settings).write(outputs);
    start.ifPresent(first::write);
    byte[] head = first.bytes();
    byte[] body = CompactForm.write(mechanism);
    String all =
        Character.toString(head.length >>> 16)
            + (char) (head.length >>> 8 & 0xff)
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
   * Returns the model of texts.
   *
   * @param texts texts from {@link #texts}
   * @throws IllegalArgumentException S-067 if they are damaged or of another version
   */
  @SuppressWarnings("unchecked") // What the list holds is looked at by whoever puts it out.
  public static CompactModel of(List<String> texts) {
    String all = String.join("", texts);
    int head =
        all.length() < HEAD ? 0 : (all.charAt(0) << 16) + (all.charAt(1) << 8) + all.charAt(2);
    if (head == 0 || all.length() < HEAD + head) {
      throw new IllegalArgumentException(
          MessageCode.MODEL_DATA_DAMAGED
              + " the model's data are damaged or of another version; build it anew");
    }
    RecordReader reader = new RecordReader(bytes(all.substring(HEAD, HEAD + head)));
    return new CompactModel(
        CompactForm.read(bytes(all.substring(HEAD + head))),
        (String) reader.read(),
        (String) reader.read(),
        (RunSettings) reader.read(),
        (List<Output>) reader.read(),
        reader.hasMore() ? Optional.of((Record) reader.read()) : Optional.empty());
  }

  private static byte[] bytes(String text) {
    return text.getBytes(StandardCharsets.ISO_8859_1);
  }

  /**
   * Returns the model with other values of its parameters, which may close its loops elsewhere.
   *
   * @param values in the order and units of {@link #parameters}
   */
  public CompactModel with(double[] values) {
    return mechanism.parameters().isEmpty()
        ? this
        : new CompactModel(mechanism.with(values), formulation, closure, settings, outputs);
  }

  /** Returns the parameters that may be changed before a run. */
  public List<TunableParameter> parameters() {
    return mechanism.parameters().stream()
        .map(p -> new TunableParameter(p.name(), p.unitInFile(), p.valueInFile()))
        .toList();
  }

  /**
   * Returns a model of the mechanism with the mechanism's events.
   *
   * @param values code for their expressions, if any, for this model only
   */
  public Model watched(Model model, Optional<WrittenValues> values) {
    return mechanism.mayChangeAbruptly()
        ? ModelParts.of(model).with(new StateEvents(mechanism, values))
        : model;
  }

  /** Returns the values of the parameters, SI units, in order. */
  public double[] parameterValues() {
    return mechanism.parameters().stream().mapToDouble(Parameter::value).toArray();
  }

  /**
   * Returns the formulation.
   *
   * @throws IllegalArgumentException S-067 if this solver does not have it
   */
  Formulation knownFormulation() {
    return Formulation.find(formulation).orElseThrow(this::unknownFormulation);
  }

  IllegalArgumentException unknownFormulation() {
    return new IllegalArgumentException(
        MessageCode.MODEL_DATA_DAMAGED
            + " the model is written in a formulation this solver does not have: "
            + formulation);
  }
}
