package org.mechservice.mechml.expression;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.regex.Pattern;
import org.mechservice.mechml.diagnosis.NearestName;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.unit.UnitSymbols;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.symbol.MathFunction;

/** Reads an expression by recursive descent; one method per rule of the grammar. */
public final class ExpressionParser {
  /** Largest depth of nesting; it bounds the recursion here and in every traversal of the tree. */
  static final int DEEPEST = 100;

  /** Names of functions in other notations. */
  private static final Map<String, String> ELSEWHERE =
      Map.of(
          "sgn", "signum", "sign", "signum", "arcsin", "asin", "arccos", "acos", "arctan", "atan",
          "ln", "log", "fabs", "abs");

  private static final Pattern INDEX = Pattern.compile("[0-9]");

  private final String text;
  private final Tokenizer tokenizer;
  private Token token;
  private int depth;

  private final Map<String, Integer> tables;

  private ExpressionParser(String text, Map<String, Integer> tables) throws ExpressionException {
    this.text = text;
    this.tables = tables;
    this.tokenizer = new Tokenizer(text);
    this.token = tokenizer.next();
  }

  /**
   * Reads an expression.
   *
   * @throws ExpressionException if the text is not an expression or nests too deeply
   */
  public static ParsedExpression parse(String text) throws ExpressionException {
    return parse(text, Map.of());
  }

  /**
   * Reads an expression that may call tables.
   *
   * @param tables number of arguments of each table, by its name
   * @throws ExpressionException if the text is not an expression or nests too deeply
   */
  public static ParsedExpression parse(String text, Map<String, Integer> tables)
      throws ExpressionException {
    ExpressionParser parser = new ExpressionParser(text, tables);
    if (parser.token.kind() == Token.Kind.END) {
      throw new ExpressionException(
          MessageCode.EXPRESSION_SYNTAX, parser.token.offset(), "a value is missing");
    }
    ParsedExpression expression = parser.sum();
    if (parser.token.kind() != Token.Kind.END) {
      throw parser.unexpected("an operator or the end");
    }
    return expression;
  }

  private ParsedExpression sum() throws ExpressionException {
    int offset = token.offset();
    List<ParsedExpression.Part> parts = new ArrayList<>();
    parts.add(new ParsedExpression.Part(false, product(), offset));
    while (token.is("+") || token.is("-")) {
      Token operator = advance();
      parts.add(new ParsedExpression.Part(operator.is("-"), product(), operator.offset()));
    }
    return parts.size() == 1 ? parts.get(0).operand() : new ParsedExpression.Sum(parts, offset);
  }

  private ParsedExpression product() throws ExpressionException {
    int offset = token.offset();
    List<ParsedExpression.Part> parts = new ArrayList<>();
    parts.add(new ParsedExpression.Part(false, signed(), offset));
    while (token.is("*") || token.is("/")) {
      Token operator = advance();
      parts.add(new ParsedExpression.Part(operator.is("/"), signed(), operator.offset()));
    }
    return parts.size() == 1 ? parts.get(0).operand() : new ParsedExpression.Product(parts, offset);
  }

  private ParsedExpression signed() throws ExpressionException {
    int offset = token.offset();
    boolean negative = false;
    while (token.is("+") || token.is("-")) {
      negative ^= advance().is("-");
    }
    ParsedExpression power = power();
    return negative ? new ParsedExpression.Negation(power, offset) : power;
  }

  /** Counts the depth: every recursion passes through this method. */
  private ParsedExpression power() throws ExpressionException {
    enter();
    ParsedExpression base = primary();
    ParsedExpression result = base;
    if (token.is("^")) {
      Token operator = advance();
      result = new ParsedExpression.Power(base, signed(), operator.offset());
    }
    depth--;
    return result;
  }

  private ParsedExpression primary() throws ExpressionException {
    if (token.kind() == Token.Kind.NUMBER) {
      return literal(advance());
    }
    if (token.kind() == Token.Kind.NAME) {
      return referenceOrCall();
    }
    if (!token.is("(")) {
      throw unexpected("a number, a name or \"(\"");
    }
    advance();
    ParsedExpression inner = sum();
    expect(")");
    return inner;
  }

  private static ParsedExpression literal(Token number) throws ExpressionException {
    double value = Double.parseDouble(number.text());
    boolean tooSmall = value == 0 && !isWrittenZero(number.text());
    if (Double.isInfinite(value) || tooSmall) {
      throw new ExpressionException(
          MessageCode.EXPRESSION_VALUE,
          number.offset(),
          Quoted.plain(number.text()) + " is too " + (tooSmall ? "small" : "large"));
    }
    return new ParsedExpression.Literal(value, number.offset());
  }

  /** Returns whether all digits before the exponent are 0. */
  private static boolean isWrittenZero(String number) {
    for (int i = 0; i < number.length(); i++) {
      char c = number.charAt(i);
      if (c == 'e' || c == 'E') {
        return true;
      }
      if (c >= '1' && c <= '9') {
        return false;
      }
    }
    return true;
  }

  private ParsedExpression referenceOrCall() throws ExpressionException {
    int offset = token.offset();
    List<String> names = new ArrayList<>();
    names.add(advance().text());
    while (token.is(".")) {
      advance();
      if (token.kind() != Token.Kind.NAME) {
        throw unexpected("a name");
      }
      names.add(advance().text());
    }
    ParsedExpression.Reference reference = new ParsedExpression.Reference(names, index(), offset);
    return token.is("(") ? call(reference) : reference;
  }

  private OptionalInt index() throws ExpressionException {
    if (!token.is("[")) {
      return OptionalInt.empty();
    }
    advance();
    if (!INDEX.matcher(token.text()).matches()) {
      throw unexpected("the number of a component, from 0 to 9");
    }
    int index = Integer.parseInt(advance().text());
    expect("]");
    return OptionalInt.of(index);
  }

  private ParsedExpression call(ParsedExpression.Reference name) throws ExpressionException {
    Integer taken = tables.get(name.text());
    if (taken != null) {
      return tableCall(name, taken);
    }
    String symbol = name.names().get(name.names().size() - 1);
    boolean prefixed = name.names().size() == 2 && name.names().get(0).equals("Math");
    MathFunction function =
        (prefixed || name.names().size() == 1) && name.index().isEmpty()
            ? MathFunction.named(symbol).orElse(null)
            : null;
    if (function == null) {
      throw new ExpressionException(
          MessageCode.EXPRESSION_NAME,
          name.offset(),
          "there is no function "
              + Quoted.of(name.text())
              + Optional.ofNullable(ELSEWHERE.get(symbol))
                  .map(ours -> "; here it is " + Quoted.of(ours))
                  .orElseGet(() -> NearestName.suggestion(symbol, known())));
    }
    List<ParsedExpression> arguments = arguments();
    if (arguments.size() != function.arity()) {
      throw new ExpressionException(
          MessageCode.EXPRESSION_SYNTAX,
          name.offset(),
          Phrase.of(
              "%s takes %d argument%s, not %d",
              symbol, function.arity(), function.arity() == 1 ? "" : "s", arguments.size()));
    }
    return new ParsedExpression.Call(function, arguments, name.offset());
  }

  private List<String> known() {
    List<String> known = new ArrayList<>(MathFunction.symbols());
    known.addAll(tables.keySet());
    return known;
  }

  private ParsedExpression tableCall(ParsedExpression.Reference name, int taken)
      throws ExpressionException {
    List<ParsedExpression> arguments = arguments();
    if (arguments.size() != taken) {
      throw new ExpressionException(
          MessageCode.EXPRESSION_SYNTAX,
          name.offset(),
          Phrase.of(
              taken == 1
                  ? "table %s takes %d argument, not %d"
                  : "map %s takes %d arguments, not %d",
              name.text(),
              taken,
              arguments.size()));
    }
    return new ParsedExpression.TableCall(name.text(), arguments, name.offset());
  }

  private List<ParsedExpression> arguments() throws ExpressionException {
    List<ParsedExpression> arguments = new ArrayList<>();
    do {
      advance();
      arguments.add(sum());
    } while (token.is(","));
    expect(")");
    return arguments;
  }

  private Token advance() throws ExpressionException {
    Token passed = token;
    token = tokenizer.next();
    return passed;
  }

  private void expect(String symbol) throws ExpressionException {
    if (!token.is(symbol)) {
      throw unexpected("an operator or " + Quoted.of(symbol));
    }
    advance();
  }

  private void enter() throws ExpressionException {
    depth++;
    if (depth > DEEPEST) {
      throw new ExpressionException(
          MessageCode.EXPRESSION_SYNTAX, token.offset(), "more than " + DEEPEST + " nested parts");
    }
  }

  private ExpressionException unexpected(String expected) {
    String found = token.kind() == Token.Kind.END ? "the end" : Quoted.of(token.text());
    return new ExpressionException(
        MessageCode.EXPRESSION_SYNTAX,
        token.offset(),
        "expected " + expected + ", found " + found + hint());
  }

  /** Returns a hint for notations of other languages. */
  private String hint() {
    if (token.is(",") && depth == 0) {
      return "; write decimals with a point and separate lists by \";\"";
    } else if (token.is("*") && text.startsWith("**", Math.max(0, token.offset() - 1))) {
      return "; write a power as 2^3";
    } else if (UnitSymbols.all().contains(token.text())) {
      return "; write the unit in its own attribute, as unit=" + Quoted.of(token.text());
    }
    return "";
  }
}
