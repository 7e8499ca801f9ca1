/**
 * The expressions that numeric attributes of MechML hold.
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
 * <p>Text becomes a tree of {@link org.mechservice.mechml.expression.ParsedExpression}; what its
 * names stand for is the business of a {@link org.mechservice.mechml.expression.Scope}.
 */
@NullMarked
package org.mechservice.mechml.expression;

import org.jspecify.annotations.NullMarked;
