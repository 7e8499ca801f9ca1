package org.mechservice.sim.service.contract;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import org.mechservice.idl.Channel;
import org.mechservice.idl.Diagnostic;
import org.mechservice.idl.FailureRecord;
import org.mechservice.idl.ModelFile;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.Severity;
import org.mechservice.idl.StepTried;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.Failure;
import org.mechservice.solver.catalogue.MessageCode;

/** Converts diagnostics, columns, failures and maps to the types of the contract. */
public final class ContractTypes {
  private ContractTypes() {}

  public static Diagnostic[] diagnostics(List<org.mechservice.mechml.diagnosis.Diagnostic> said) {
    return said.stream().map(ContractTypes::diagnostic).toArray(Diagnostic[]::new);
  }

  private static Diagnostic diagnostic(org.mechservice.mechml.diagnosis.Diagnostic said) {
    Severity level =
        switch (said.severity()) {
          case INFO -> Severity.SEV_INFO;
          case WARNING -> Severity.SEV_WARNING;
          case ERROR -> Severity.SEV_ERROR;
        };
    return new Diagnostic(
        level,
        said.code().code(),
        said.message(),
        said.file(),
        said.path(),
        said.line(),
        said.column());
  }

  public static Diagnostic information(MessageCode code, String text) {
    return diagnostic(Severity.SEV_INFO, code, text);
  }

  public static Diagnostic diagnostic(Severity weight, MessageCode code, String text) {
    return new Diagnostic(weight, code.code(), text, "", "", 0, 0);
  }

  /** Returns a text as a file. */
  public static ModelFile file(String name, String text) {
    return new ModelFile(name, text.getBytes(StandardCharsets.UTF_8));
  }

  public static Channel[] channels(List<Variable> variables) {
    return variables.stream()
        .map(variable -> new Channel(variable.name(), variable.unit()))
        .toArray(Channel[]::new);
  }

  public static NameValue[] nameValues(Map<String, String> map) {
    return map.entrySet().stream()
        .map(entry -> new NameValue(entry.getKey(), entry.getValue()))
        .toArray(NameValue[]::new);
  }

  private static StepTried step(Failure.Step step) {
    return new StepTried(step.time(), step.stepSize(), step.order(), step.error());
  }

  public static FailureRecord failure(Failure failure) {
    return new FailureRecord(
        failure.code().code(),
        failure.cause(),
        failure.time(),
        failure.stepSize(),
        failure.order(),
        failure.part(),
        failure.advice(),
        failure.lastSteps().stream().map(ContractTypes::step).toArray(StepTried[]::new));
  }
}
