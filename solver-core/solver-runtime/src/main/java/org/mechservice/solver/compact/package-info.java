/**
 * The compact form of a model: data that travel instead of generated code.
 *
 * <p>{@link org.mechservice.solver.compact.CompactForm} converts a mechanism to bytes and back
 * without changing a bit of its numbers; {@code RecordWriter} and {@code RecordReader} do the work.
 * {@link org.mechservice.solver.compact.CompactModel} carries these bytes as texts in a class file,
 * together with the names of the formulation and of the closure. {@link
 * org.mechservice.solver.compact.DataDrivenTree} and {@link
 * org.mechservice.solver.compact.DataDrivenLoops} select the formulation with that name; a model's
 * class names the one it needs, so that its standalone JAR does without the other. {@link
 * org.mechservice.solver.compact.LoadedUserForces} takes user forces, which remain classes, from
 * the class loader of the model's JAR.
 *
 * <p>The package depends on {@code solver.api} and on the mechanics of the model.
 */
package org.mechservice.solver.compact;
