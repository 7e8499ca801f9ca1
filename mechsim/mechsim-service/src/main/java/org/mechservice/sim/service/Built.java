package org.mechservice.sim.service;

import java.util.List;
import java.util.function.Supplier;
import org.mechservice.idl.InvalidModel;
import org.mechservice.idl.InvalidOption;
import org.mechservice.idl.OPT_COLUMNS;
import org.mechservice.idl.OPT_FORMULATION;
import org.mechservice.idl.OPT_INTEGRATOR;
import org.mechservice.idl.OPT_SET;
import org.mechservice.idl.ServerFailure;
import org.mechservice.mechml.diagnosis.Diagnostic;
import org.mechservice.sim.scene.ModelBuildException;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.catalogue.Severity;

/** Says in the contract's words why a model cannot be built. */
final class Built {
  private Built() {}

  /**
   * Builds, or says why not.
   *
   * @throws InvalidOption if the formulation, the integrator or a column group does not fit
   * @throws InvalidModel if the model itself cannot become a class
   * @throws ServerFailure if this process cannot compile
   */
  static <T> T orRefused(Supplier<T> build) throws InvalidOption, InvalidModel, ServerFailure {
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
   * Says that a parameter cannot be set.
   *
   * @param refusal S-125 or S-126; anything else is thrown as it is
   */
  static InvalidOption refusedParameter(IllegalArgumentException refusal) {
    for (MessageCode code :
        List.of(MessageCode.PARAMETER_FIXED, MessageCode.PARAMETER_NOT_A_NUMBER)) {
      if (String.valueOf(refusal.getMessage()).startsWith(code + " ")) {
        return new InvalidOption(code.code(), withoutCode(code, refusal), OPT_SET.value);
      }
    }
    throw refusal;
  }

  private static InvalidModel invalidModel(MessageCode code, String text) {
    return Refusal.model(List.of(new Diagnostic(Severity.ERROR, code, text, "", 0, 0, "")));
  }

  private static String withoutCode(MessageCode code, RuntimeException e) {
    String message = String.valueOf(e.getMessage());
    return message.startsWith(code + " ") ? message.substring(code.code().length() + 1) : message;
  }
}
