/**
 * Models in several files: {@code <include>} puts the parts of another file, a subsystem, into a
 * model, once or several times.
 *
 * <p>The text of a model holds everything. Whoever reads it from a folder appends each file that it
 * includes as an element {@code included}, word for word, so that the reader opens no file, and a
 * server needs none. {@link org.mechservice.mechml.include.IncludedParts} reads these texts as
 * files of their own, with positions in them, and puts their elements in the sections of the model.
 * {@link org.mechservice.mechml.include.Instance} is one use of a subsystem: it prefixes the names
 * that the subsystem defines wherever they stand, also in expressions, which {@link
 * org.mechservice.mechml.include.Renaming} does, replaces values of its parameters, and binds names
 * that it leaves open to names of the model. All later readers see one model without includes.
 */
@NullMarked
package org.mechservice.mechml.include;

import org.jspecify.annotations.NullMarked;
