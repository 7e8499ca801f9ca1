/**
 * Expressions whose value changes during a run, and the names that they may use.
 *
 * <p>{@link org.mechservice.mechml.resolve.formula.FormulaReader} reads an attribute to an
 * expression of the solver in SI units. {@link
 * org.mechservice.mechml.resolve.formula.FormulaTranslation} translates the parsed expression and
 * folds constant parts; {@link org.mechservice.mechml.resolve.formula.FormulaNames} resolves names
 * such as {@code knee.q} or {@code bar.p1.vx}; {@link
 * org.mechservice.mechml.resolve.formula.FormulaRole} says which names the attribute allows.
 *
 * <p>{@link org.mechservice.mechml.resolve.formula.MechanismNames} finds bodies, points and joints
 * by name after the joints to be cut have been chosen. {@link
 * org.mechservice.mechml.resolve.formula.CoordinateReader} and {@link
 * org.mechservice.mechml.resolve.formula.FrameReader} read coordinates and body-fixed frames that
 * forces and constraints name.
 *
 * <p>Formulas see lengths in the file's unit and angles in rad.
 */
@NullMarked
package org.mechservice.mechml.resolve.formula;

import org.jspecify.annotations.NullMarked;
