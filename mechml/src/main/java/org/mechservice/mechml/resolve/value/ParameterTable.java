package org.mechservice.mechml.resolve.value;

import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.expression.ExpressionException;
import org.mechservice.mechml.expression.ParsedExpression;
import org.mechservice.mechml.expression.Scope;
import org.mechservice.solver.api.ModelParameter;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * The parameters of a model; the scope of constant expressions, which may use parameters and PI.
 */
public final class ParameterTable implements Scope {
  private final Map<String, ResolvedParameter> parameters = new LinkedHashMap<>();
  private final Map<String, Integer> tunable = new LinkedHashMap<>();
  private final Set<String> used = new HashSet<>();
  private final Set<String> unreadable;

  /**
   * Begins without parameters.
   *
   * @param unreadable names of the parameters that could not be read
   */
  ParameterTable(Set<String> unreadable) {
    this.unreadable = unreadable;
  }

  void add(ResolvedParameter parameter) {
    if (parameters.putIfAbsent(parameter.name(), parameter) == null && parameter.tunable()) {
      tunable.put(parameter.name(), tunable.size());
    }
  }

  /** Returns the parameter that a name in an expression refers to. */
  public Optional<ResolvedParameter> find(ParsedExpression.Reference name) {
    used.add(name.text());
    return name.names().size() == 1 && name.index().isEmpty()
        ? Optional.ofNullable(parameters.get(name.text()))
        : Optional.empty();
  }

  /** Returns all parameters, in file order. */
  public List<ModelParameter> all() {
    return parameters.values().stream()
        .map(p -> new ModelParameter(p.name(), p.unitSymbol(), p.value(), p.tunable()))
        .toList();
  }

  /** Returns the tunable parameters in the order of their indices. */
  public List<ResolvedParameter> tunable() {
    return parameters.values().stream().filter(ResolvedParameter::tunable).toList();
  }

  /** Returns the index of a tunable parameter among the model's. */
  public int indexOf(ResolvedParameter parameter) {
    return tunable.getOrDefault(parameter.name(), -1);
  }

  /** Returns the unused parameters in file order. */
  public List<ResolvedParameter> unused() {
    return parameters.values().stream().filter(p -> !used.contains(p.name())).toList();
  }

  public Set<String> names() {
    return parameters.keySet();
  }

  /** Returns whether a parameter of this name was given and has been reported already. */
  boolean isUnreadable(String name) {
    return unreadable.contains(name);
  }

  @Override
  public double value(ParsedExpression.Reference name) throws ExpressionException {
    Optional<ResolvedParameter> parameter = find(name);
    if (parameter.isEmpty()) {
      refuseVariable(name);
      return Scope.constant(name, names());
    }
    if (parameter.get().tunable()) {
      throw new ExpressionException(
          MessageCode.TUNABLE_PARAMETER_MISPLACED,
          name.offset(),
          Quoted.of(name.text())
              + " is tunable, but this value must be known when the model is read; use tunable"
              + " parameters in forces, motions and outputs only");
    }
    return parameter.get().valueInExpressions();
  }

  private static void refuseVariable(ParsedExpression.Reference name) throws ExpressionException {
    if (name.text().equals("t") || (name.names().size() > 1 && !name.text().equals("Math.PI"))) {
      throw new ExpressionException(
          MessageCode.EXPRESSION_NAME,
          name.offset(),
          Quoted.of(name.text())
              + " changes during a run, but this value must be constant; use numbers and parameters"
              + " only");
    }
  }
}
