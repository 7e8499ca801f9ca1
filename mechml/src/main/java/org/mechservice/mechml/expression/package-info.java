/**
 * Expressions in the numeric attributes of MechML: grammar, parser, constant evaluation.
 *
 * <pre>
 * sum     = product { ("+" | "-") product }
 * product = signed { ("*" | "/") signed }
 * signed  = { "+" | "-" } power
 * power   = primary [ "^" signed ]                    right to left; -2^2 is -4
 * primary = number | "(" sum ")" | name { "." name } [ "[" digit "]" | "(" sum { "," sum } ")" ]
 * name    = letter or "_", then letters, digits, "_"  |  "'" anything but "'" "'"
 * number  = digits [ "." [digits] ] [exponent]  |  "." digits [exponent]
 * </pre>
 *
 * <p>{@link org.mechservice.mechml.expression.ExpressionParser} turns text into a tree of {@link
 * org.mechservice.mechml.expression.ParsedExpression}. {@link
 * org.mechservice.mechml.expression.ConstantEvaluation} computes the value of a constant
 * expression; a {@link org.mechservice.mechml.expression.Scope} gives the names their values. Every
 * error is an {@link org.mechservice.mechml.expression.ExpressionException} with the character
 * where it occurs.
 *
 * <p>Functions are those of the catalogue {@link org.mechservice.solver.symbol.MathFunction}: a
 * constant has the bits that a run would give it, on every machine.
 */
@NullMarked
package org.mechservice.mechml.expression;

import org.jspecify.annotations.NullMarked;
