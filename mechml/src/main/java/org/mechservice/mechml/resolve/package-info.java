/**
 * From the bytes of a MechML file to the model.
 *
 * <p>{@link org.mechservice.mechml.resolve.MechmlReader} is the entry point: it reads the document
 * as a {@link org.mechservice.mechml.resolve.ValidatedFile}, which can be resolved with other
 * values again, and passes it to {@link org.mechservice.mechml.resolve.ModelResolver}, which runs
 * the readers in order. {@link org.mechservice.mechml.resolve.MechanismReader} reads the model
 * block in two steps: first bodies, root and joints, then everything that refers to them by name.
 *
 * <p>Each subpackage reads one part of the file. {@code value} reads numbers, parameters and names;
 * {@code body} bodies and the root; {@code formula} expressions that change during a run, and the
 * coordinates and frames they name; {@code joint} joints and constraints; {@code force} forces;
 * {@code simulation} simulation blocks. The dependencies point from the later ones in this list to
 * the earlier ones.
 *
 * <p>One class reads one kind of element. A reader that finds an error reports it to the
 * diagnostics and returns an empty result, so that one reading finds all independent errors.
 */
@NullMarked
package org.mechservice.mechml.resolve;

import org.jspecify.annotations.NullMarked;
