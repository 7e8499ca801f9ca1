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
import org.mechservice.mechml.diagnosis.Severity;
import org.mechservice.sim.scene.ModelBuildException;

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
   * Says that a parameter cannot be set.
   *
   * @param refusal S-125 or S-126; anything else is thrown as it is
   */
  static InvalidOption refusedParameter(IllegalArgumentException refusal) {
    for (String code : List.of("S-125", "S-126")) {
      if (String.valueOf(refusal.getMessage()).startsWith(code + " ")) {
        return new InvalidOption(code, withoutCode(code, refusal), OPT_SET.value);
      }
    }
    throw refusal;
  }

  private static InvalidModel invalidModel(String code, String text) {
    return Refusal.model(List.of(new Diagnostic(Severity.ERROR, code, text, "", 0, 0, "")));
  }

  private static String withoutCode(String code, RuntimeException e) {
    String message = String.valueOf(e.getMessage());
    return message.startsWith(code + " ") ? message.substring(code.length() + 1) : message;
  }
}
