/**
 * Numbers, parameters and names of a model file.
 *
 * <p>{@link org.mechservice.mechml.resolve.value.ValueReader} reads a numeric attribute: it parses
 * the expression, inserts the parameters, applies the unit and returns a number in SI. {@link
 * org.mechservice.mechml.resolve.value.ParametersReader} evaluates the file's parameters in the
 * order of their dependencies and stores them in a {@link
 * org.mechservice.mechml.resolve.value.ParameterTable}. {@link
 * org.mechservice.mechml.resolve.value.SettingReader} and {@link
 * org.mechservice.mechml.resolve.value.DirectionReader} read numbers within bounds and unit
 * vectors.
 *
 * <p>{@link org.mechservice.mechml.resolve.value.NameTable} maps the names of one kind of element
 * to what was read, and reports duplicate, unusable and unknown names.
 *
 * <p>The package depends on {@code document}, {@code expression} and {@code unit}.
 */
@NullMarked
package org.mechservice.mechml.resolve.value;

import org.jspecify.annotations.NullMarked;
