package org.mechservice.mechml.expression;

/**
 * A token of an expression.
 *
 * @param kind kind of token
 * @param text as written; a quoted name without its quotes
 * @param offset of its first character, from 0
 */
record Token(Kind kind, String text, int offset) {
  enum Kind {
    NUMBER,
    NAME,
    SYMBOL,
    END
  }

  boolean is(String symbol) {
    return kind == Kind.SYMBOL && text.equals(symbol);
  }
}
