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
import org.mechservice.sim.scene.ModelBuildException;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.catalogue.Severity;
import org.omg.CORBA.IMP_LIMIT;

/**
 * Makes the exceptions of the contract, each with its code of the error catalogue, also from the
 * exceptions of the model builder.
 */
public final class ContractErrors {
  private ContractErrors() {}

  /** Returns the refusal of an operation that this version does not support. */
  public static NotAvailable notAvailable(String text) {
    return new NotAvailable(MessageCode.NOT_AVAILABLE.code(), text);
  }

  /** Returns the refusal of an unknown option or of its value. */
  public static InvalidOption option(String name, String text) {
    return new InvalidOption(MessageCode.OPTION_VALUE.code(), text, name);
  }

  /** Returns the refusal of an operation in the present state. */
  public static InvalidState state(SimState current, String text) {
    return new InvalidState(MessageCode.WRONG_STATE.code(), text, current);
  }

  /**
   * Returns the refusal of a value above a limit.
   *
   * @param name the limit, as {@code limits} lists it
   * @param value what it allows
   * @param requested value requested
   */
  public static LimitExceeded limit(String name, long value, long requested, String text) {
    return new LimitExceeded(MessageCode.LIMIT_EXCEEDED.code(), text, name, value, requested);
  }

  /** Returns a refusal of an operation whose contract has none of this kind. */
  public static IMP_LIMIT undeclared(LimitExceeded refusal) {
    return new IMP_LIMIT(refusal.code + " " + refusal.text);
  }

  /** Returns the refusal of a session because no host accepts one. */
  public static LimitExceeded noPlace(String text) {
    return new LimitExceeded(MessageCode.NO_PLACE_FOR_SESSION.code(), text, "places", 0, 1);
  }

  /** Returns the refusal of an unknown or expired name. */
  public static NotFound notFound(String text) {
    return new NotFound(MessageCode.NO_SUCH_OBJECT.code(), text);
  }

  /**
   * Returns the refusal of a model with errors.
   *
   * @param diagnostics of the model; at least one is an error
   */
  public static InvalidModel model(List<Diagnostic> diagnostics) {
    long errors = diagnostics.stream().filter(said -> said.severity() == Severity.ERROR).count();
    return new InvalidModel(
        MessageCode.MODEL_FILE_UNUSABLE.code(),
        "the model has " + errors + (errors == 1 ? " error" : " errors"),
        ContractTypes.diagnostics(diagnostics));
  }

  /**
   * Refuses a strict request of a model with warnings.
   *
   * @throws InvalidModel if there are any
   */
  public static void requireNoWarnings(List<Diagnostic> warnings) throws InvalidModel {
    int count = warnings.size();
    if (count > 0) {
      throw new InvalidModel(
          MessageCode.WARNINGS_REFUSED.code(),
          "the model has "
              + count
              + (count == 1 ? " warning" : " warnings")
              + ", and strict was set",
          ContractTypes.diagnostics(warnings));
    }
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
        case FORMULATION_NOT_AVAILABLE ->
            throw new InvalidOption(e.code().code(), text, OPT_FORMULATION.value);
        case INTEGRATOR_NOT_AVAILABLE ->
            throw new InvalidOption(e.code().code(), text, OPT_INTEGRATOR.value);
        case NO_COMPILER -> throw new ServerFailure(e.code().code(), text, "");
        default -> throw invalidModel(e.code(), text);
      }
    } catch (IllegalArgumentException e) {
      String message = String.valueOf(e.getMessage());
      if (message.startsWith(MessageCode.COLUMN_GROUP_MISSING + " ")) {
        throw new InvalidOption(
            MessageCode.COLUMN_GROUP_MISSING.code(),
            withoutCode(MessageCode.COLUMN_GROUP_MISSING, e),
            OPT_COLUMNS.value);
      } else if (message.startsWith(MessageCode.FORCE_CLASS_UNUSABLE + " ")) {
        throw invalidModel(
            MessageCode.FORCE_CLASS_UNUSABLE, withoutCode(MessageCode.FORCE_CLASS_UNUSABLE, e));
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
    for (MessageCode code :
        List.of(MessageCode.PARAMETER_FIXED, MessageCode.PARAMETER_NOT_A_NUMBER)) {
      if (String.valueOf(refusal.getMessage()).startsWith(code + " ")) {
        return new InvalidOption(code.code(), withoutCode(code, refusal), OPT_SET.value);
      }
    }
    throw refusal;
  }

  private static InvalidModel invalidModel(MessageCode code, String text) {
    return model(List.of(new Diagnostic(Severity.ERROR, code, text, "", 0, 0, "")));
  }

  private static String withoutCode(MessageCode code, RuntimeException e) {
    String message = String.valueOf(e.getMessage());
    return message.startsWith(code + " ") ? message.substring(code.code().length() + 1) : message;
  }
}
