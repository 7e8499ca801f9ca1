/**
 * Units of measurement: their dimension and their size in SI.
 *
 * <p>{@link org.mechservice.mechml.unit.Unit} is a factor to SI with a {@link
 * org.mechservice.mechml.unit.Dimension}. {@link org.mechservice.mechml.unit.UnitParser} reads
 * texts such as {@code kg*m^2} with the symbols of {@link org.mechservice.mechml.unit.UnitSymbols}.
 * {@link org.mechservice.mechml.unit.UnitSystem} holds the units of a file's bare numbers, and
 * {@link org.mechservice.mechml.unit.Quantity} says for each kind of attribute which unit applies.
 *
 * <p>Angles have a dimension of their own, so that the reader can tell degrees from pure numbers.
 * The sizes of the units are those of the SI brochure (BIPM, 9th edition) and of the international
 * yard and pound agreement of 1959.
 */
@NullMarked
package org.mechservice.mechml.unit;

import org.jspecify.annotations.NullMarked;
