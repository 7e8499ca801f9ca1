package org.mechservice.sim.service;

import java.util.List;
import org.mechservice.idl.InvalidModel;
import org.mechservice.idl.InvalidOption;
import org.mechservice.idl.InvalidState;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.idl.NotAvailable;
import org.mechservice.idl.NotFound;
import org.mechservice.idl.SimState;
import org.mechservice.mechml.diagnosis.Diagnostic;
import org.mechservice.solver.catalogue.MessageCode;

/** The exceptions of the contract, each with its entry of the error catalogue. */
public final class Refusal {
  private Refusal() {}

  /** The interface has it, this version has not. */
  public static NotAvailable notAvailable(String text) {
    return new NotAvailable(MessageCode.NOT_AVAILABLE.code(), text);
  }

  /** An option is unknown or its value is not usable. */
  public static InvalidOption option(String name, String text) {
    return new InvalidOption(MessageCode.OPTION_VALUE.code(), text, name);
  }

  /** Not possible now. */
  public static InvalidState state(SimState current, String text) {
    return new InvalidState(MessageCode.WRONG_STATE.code(), text, current);
  }

  /**
   * More than this server allows.
   *
   * @param name the limit, as {@code limits} lists it
   * @param value what it allows
   * @param requested what was asked for
   */
  public static LimitExceeded limit(String name, long value, long requested, String text) {
    return new LimitExceeded(MessageCode.LIMIT_EXCEEDED.code(), text, name, value, requested);
  }

  /** No host takes a session now. */
  public static LimitExceeded noPlace(String text) {
    return new LimitExceeded(MessageCode.NO_PLACE_FOR_SESSION.code(), text, "places", 0, 1);
  }

  /** There is no such thing, or no longer. */
  public static NotFound notFound(String text) {
    return new NotFound(MessageCode.NO_SUCH_OBJECT.code(), text);
  }

  /**
   * The model cannot be used.
   *
   * @param diagnostics why, at least one of them an error
   */
  public static InvalidModel model(List<Diagnostic> diagnostics) {
    long errors =
        diagnostics.stream()
            .filter(said -> said.severity() == org.mechservice.solver.catalogue.Severity.ERROR)
            .count();
    return new InvalidModel(
        MessageCode.MODEL_FILE_UNUSABLE.code(),
        "the model has " + errors + (errors == 1 ? " error" : " errors"),
        Wire.diagnostics(diagnostics));
  }

  /** There are warnings, and the request is strict. */
  static InvalidModel strict(List<Diagnostic> warnings) {
    int count = warnings.size();
    return new InvalidModel(
        MessageCode.WARNINGS_REFUSED.code(),
        "the model has " + count + (count == 1 ? " warning" : " warnings") + ", and strict was set",
        Wire.diagnostics(warnings));
  }
}
