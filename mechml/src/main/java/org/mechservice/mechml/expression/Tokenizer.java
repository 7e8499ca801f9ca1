package org.mechservice.mechml.expression;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.solver.catalogue.MessageCode;

/** Splits the text of an expression into tokens. */
final class Tokenizer {
  /** Possessive quantifiers avoid backtracking in long rows of digits. */
  private static final Pattern NUMBER =
      Pattern.compile("(?:[0-9]++\\.?+[0-9]*+|\\.[0-9]++)(?:[eE][+-]?+[0-9]++)?+");

  private static final Pattern NAME = Pattern.compile("[A-Za-z_][A-Za-z0-9_]*+");
  private static final Pattern QUOTED_NAME = Pattern.compile("'([^']++)'");
  private static final String SYMBOLS = "+-*/^(),.[]";

  private final String text;
  private int position;

  Tokenizer(String text) {
    this.text = text;
  }

  Token next() throws ExpressionException {
    skipWhiteSpace();
    if (position == text.length()) {
      return new Token(Token.Kind.END, "", position);
    }
    Matcher number = at(NUMBER);
    if (number.lookingAt()) {
      return take(Token.Kind.NUMBER, number.group(), number.end());
    }
    Matcher name = at(NAME);
    if (name.lookingAt()) {
      return take(Token.Kind.NAME, name.group(), name.end());
    }
    Matcher quoted = at(QUOTED_NAME);
    if (quoted.lookingAt()) {
      return take(Token.Kind.NAME, String.valueOf(quoted.group(1)), quoted.end());
    }
    if (SYMBOLS.indexOf(text.charAt(position)) >= 0) {
      return take(Token.Kind.SYMBOL, text.substring(position, position + 1), position + 1);
    }
    throw new ExpressionException(
        MessageCode.EXPRESSION_SYNTAX,
        position,
        Quoted.of(Character.toString(text.codePointAt(position)))
            + " has no meaning here"
            + hint());
  }

  /** Returns a hint for notations of other languages. */
  private String hint() {
    return switch (text.charAt(position)) {
      case '<', '>', '=', '?', '&', '|', '!' ->
          "; write a case distinction with step, smoothStep, min or max";
      case ';' -> "; a list is not permitted here, and arguments are separated by \",\"";
      case '\u00b0' -> "; write angleUnits or unit to use degrees";
      default -> "";
    };
  }

  private void skipWhiteSpace() {
    while (position < text.length() && Character.isWhitespace(text.charAt(position))) {
      position++;
    }
  }

  private Matcher at(Pattern pattern) {
    return pattern.matcher(text).region(position, text.length());
  }

  private Token take(Token.Kind kind, String word, int end) {
    Token token = new Token(kind, word, position);
    position = end;
    return token;
  }
}
