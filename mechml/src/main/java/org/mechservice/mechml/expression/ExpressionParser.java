package org.mechservice.mechml.expression;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.mechml.diagnosis.MessageCode;
import org.mechservice.mechml.diagnosis.Nearest;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;

/** Reads an expression by recursive descent; one method per rule of the grammar. */
public final class ExpressionParser {
  /** Deeper nesting is refused, which bounds the stack here and wherever the tree is walked. */
  static final int DEEPEST = 100;

  private final Tokenizer tokenizer;
  private Token token;
  private int depth;

  private ExpressionParser(String text) throws ExpressionException {
    this.tokenizer = new Tokenizer(text);
    this.token = tokenizer.next();
  }

  /**
   * Reads an expression.
   *
   * @throws ExpressionException if the text is not an expression or nests too deeply
   */
  public static Expression parse(String text) throws ExpressionException {
    ExpressionParser parser = new ExpressionParser(text);
    if (parser.token.kind() == Token.Kind.END) {
      throw new ExpressionException(
          MessageCode.EXPRESSION_SYNTAX, parser.token.offset(), "a value is missing");
    }
    Expression expression = parser.sum();
    if (parser.token.kind() != Token.Kind.END) {
      throw parser.unexpected("an operator or the end");
    }
    return expression;
  }

  private Expression sum() throws ExpressionException {
    int offset = token.offset();
    List<Expression.Part> parts = new ArrayList<>();
    parts.add(new Expression.Part(false, product(), offset));
    while (token.is("+") || token.is("-")) {
      Token operator = advance();
      parts.add(new Expression.Part(operator.is("-"), product(), operator.offset()));
    }
    return parts.size() == 1 ? parts.get(0).operand() : new Expression.Sum(parts, offset);
  }

  private Expression product() throws ExpressionException {
    int offset = token.offset();
    List<Expression.Part> parts = new ArrayList<>();
    parts.add(new Expression.Part(false, signed(), offset));
    while (token.is("*") || token.is("/")) {
      Token operator = advance();
      parts.add(new Expression.Part(operator.is("/"), signed(), operator.offset()));
    }
    return parts.size() == 1 ? parts.get(0).operand() : new Expression.Product(parts, offset);
  }

  private Expression signed() throws ExpressionException {
    int offset = token.offset();
    boolean negative = false;
    while (token.is("+") || token.is("-")) {
      negative ^= advance().is("-");
    }
    Expression power = power();
    return negative ? new Expression.Negation(power, offset) : power;
  }

  /** Every way down leads through here, so here the depth is counted. */
  private Expression power() throws ExpressionException {
    enter();
    Expression base = primary();
    Expression result = base;
    if (token.is("^")) {
      Token operator = advance();
      result = new Expression.Power(base, signed(), operator.offset());
    }
    depth--;
    return result;
  }

  private Expression primary() throws ExpressionException {
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
    Expression inner = sum();
    expect(")");
    return inner;
  }

  private static Expression literal(Token number) throws ExpressionException {
    double value = Double.parseDouble(number.text());
    boolean written = number.text().split("[eE]", 2)[0].chars().anyMatch(c -> c >= '1' && c <= '9');
    if (Double.isInfinite(value) || (value == 0 && written)) {
      throw new ExpressionException(
          MessageCode.EXPRESSION_VALUE,
          number.offset(),
          Quoted.plain(number.text()) + " is too " + (written && value == 0 ? "small" : "large"));
    }
    return new Expression.Literal(value, number.offset());
  }

  private Expression referenceOrCall() throws ExpressionException {
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
    Expression.Reference reference = new Expression.Reference(names, offset);
    return token.is("(") ? call(reference) : reference;
  }

  private Expression call(Expression.Reference name) throws ExpressionException {
    String symbol = name.names().get(name.names().size() - 1);
    boolean prefixed = name.names().size() == 2 && name.names().get(0).equals("Math");
    Function function =
        prefixed || name.names().size() == 1 ? Function.named(symbol).orElse(null) : null;
    if (function == null) {
      throw new ExpressionException(
          MessageCode.EXPRESSION_NAME,
          name.offset(),
          "there is no function "
              + Quoted.of(name.text())
              + Nearest.suggestion(symbol, Function.symbols()));
    }
    List<Expression> arguments = arguments();
    if (arguments.size() != function.arity()) {
      throw new ExpressionException(
          MessageCode.EXPRESSION_SYNTAX,
          name.offset(),
          Phrase.of(
              "%s takes %d argument%s, not %d",
              symbol, function.arity(), function.arity() == 1 ? "" : "s", arguments.size()));
    }
    return new Expression.Call(function, arguments, name.offset());
  }

  private List<Expression> arguments() throws ExpressionException {
    List<Expression> arguments = new ArrayList<>();
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
          MessageCode.EXPRESSION_SYNTAX,
          token.offset(),
          "more than " + DEEPEST + " parts nested in each other");
    }
  }

  private ExpressionException unexpected(String expected) {
    String found = token.kind() == Token.Kind.END ? "the end" : Quoted.of(token.text());
    String hint = token.is(",") && depth == 0 ? "; decimals have a point" : "";
    return new ExpressionException(
        MessageCode.EXPRESSION_SYNTAX,
        token.offset(),
        "expected " + expected + ", found " + found + hint);
  }
}
