/**
 * The messages about a model file.
 *
 * <p>{@link org.mechservice.mechml.diagnosis.Diagnostics} collects the errors and warnings of one
 * reading; each reader adds to it and carries on, so that one reading finds all independent errors.
 * Each message is a {@link org.mechservice.mechml.diagnosis.Diagnostic} with a code, a severity and
 * a {@link org.mechservice.mechml.diagnosis.SourcePosition}. If there is an error, the reading ends
 * with a {@link org.mechservice.mechml.diagnosis.MechmlException} that carries all messages.
 *
 * <p>Three classes format messages: {@link org.mechservice.mechml.diagnosis.Phrase} fills in
 * numbers independently of the machine's language, {@link org.mechservice.mechml.diagnosis.Quoted}
 * makes text from a file safe to print, and {@link org.mechservice.mechml.diagnosis.NearestName}
 * suggests the name that a user most likely meant.
 *
 * <p>The package depends on no other package of MechML.
 */
@NullMarked
package org.mechservice.mechml.diagnosis;

import org.jspecify.annotations.NullMarked;
