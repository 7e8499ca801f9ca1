package org.mechservice.sim.service.contract;

import java.util.List;
import java.util.function.Supplier;
import org.mechservice.idl.InvalidModel;
import org.mechservice.idl.InvalidOption;
import org.mechservice.idl.InvalidState;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.idl.NotAvailable;
import org.mechservice.idl.NotFound;
import org.mechservice.idl.OPT_COLUMNS;
import org.mechservice.idl.OPT_FORMULATION;
import org.mechservice.idl.OPT_INTEGRATOR;
import org.mechservice.idl.OPT_SET;
import org.mechservice.idl.ServerFailure;
import org.mechservice.idl.SimState;
import org.mechservice.mechml.diagnosis.Diagnostic;
import org.mechservice.mechml.diagnosis.Severity;
import org.mechservice.sim.scene.ModelBuildException;

/**
 * Makes the exceptions of the contract, each with its code of the error catalogue, also from the
 * exceptions of the model builder.
 */
public final class ContractErrors {
  private ContractErrors() {}

  /** Returns the refusal of an operation that this version does not support. */
  public static NotAvailable notAvailable(String text) {
    return new NotAvailable("S-007", text);
  }

  /** Returns the refusal of an unknown option or of its value. */
  public static InvalidOption option(String name, String text) {
    return new InvalidOption("S-008", text, name);
  }

  /** Returns the refusal of an operation in the present state. */
  public static InvalidState state(SimState current, String text) {
    return new InvalidState("S-009", text, current);
  }

  /**
   * Returns the refusal of a value above a limit.
   *
   * @param name the limit, as {@code limits} lists it
   * @param value what it allows
   * @param requested value requested
   */
  public static LimitExceeded limit(String name, long value, long requested, String text) {
    return new LimitExceeded("S-010", text, name, value, requested);
  }

  /** Returns the refusal of a session because no host accepts one. */
  public static LimitExceeded noPlace(String text) {
    return new LimitExceeded("S-012", text, "places", 0, 1);
  }

  /** Returns the refusal of an unknown or expired name. */
  public static NotFound notFound(String text) {
    return new NotFound("S-011", text);
  }

  /**
   * Returns the refusal of a model with errors.
   *
   * @param diagnostics of the model; at least one is an error
   */
  public static InvalidModel model(List<Diagnostic> diagnostics) {
    long errors = diagnostics.stream().filter(said -> said.severity() == Severity.ERROR).count();
    return new InvalidModel(
        "S-016",
        "the model has " + errors + (errors == 1 ? " error" : " errors"),
        ContractTypes.diagnostics(diagnostics));
  }

  /** Returns the refusal of a model with warnings by a strict request. */
  public static InvalidModel strict(List<Diagnostic> warnings) {
    int count = warnings.size();
    return new InvalidModel(
        "S-164",
        "the model has " + count + (count == 1 ? " warning" : " warnings") + ", and strict was set",
        ContractTypes.diagnostics(warnings));
  }

  /**
   * Builds, and translates what the builder throws.
   *
   * @throws InvalidOption if the formulation, the integrator or a column group does not fit
   * @throws InvalidModel if the model itself cannot become a class
   * @throws ServerFailure if this process cannot compile
   */
  public static <T> T build(Supplier<T> build) throws InvalidOption, InvalidModel, ServerFailure {
    try {
      return build.get();
    } catch (ModelBuildException e) {
      String text = withoutCode(e.code(), e);
      switch (e.code()) {
        case "S-081" -> throw new InvalidOption(e.code(), text, OPT_FORMULATION.value);
        case "S-082" -> throw new InvalidOption(e.code(), text, OPT_INTEGRATOR.value);
        case "S-084" -> throw new ServerFailure(e.code(), text, "");
        default -> throw invalidModel(e.code(), text);
      }
    } catch (IllegalArgumentException e) {
      String message = String.valueOf(e.getMessage());
      if (message.startsWith("S-060 ")) {
        throw new InvalidOption("S-060", withoutCode("S-060", e), OPT_COLUMNS.value);
      } else if (message.startsWith("S-068 ")) {
        throw invalidModel("S-068", withoutCode("S-068", e));
      }
      throw e;
    }
  }

  /**
   * Translates the refusal of a parameter.
   *
   * @param refusal its message begins with S-125 or S-126; any other is thrown as it is
   */
  public static InvalidOption parameter(IllegalArgumentException refusal) {
    for (String code : List.of("S-125", "S-126")) {
      if (String.valueOf(refusal.getMessage()).startsWith(code + " ")) {
        return new InvalidOption(code, withoutCode(code, refusal), OPT_SET.value);
      }
    }
    throw refusal;
  }

  private static InvalidModel invalidModel(String code, String text) {
    return model(List.of(new Diagnostic(Severity.ERROR, code, text, "", 0, 0, "")));
  }

  private static String withoutCode(String code, RuntimeException e) {
    String message = String.valueOf(e.getMessage());
    return message.startsWith(code + " ") ? message.substring(code.length() + 1) : message;
  }
}
