/**
 * Surfaces of triangles: what bodies look like.
 *
 * <p>A {@link org.mechservice.view.mesh.Mesh} holds triangles and a colour, in the axes of one
 * body, in m. {@link org.mechservice.view.mesh.Solids} makes the simple ones: box, sphere,
 * cylinder, cone. {@link org.mechservice.view.mesh.MeshFolder} reads those of a geometry file that
 * a model names by {@code graphSrc}: VRML 97, STL (text and binary), OBJ and glTF 2.0, by the
 * ending of its name.
 *
 * <p>Model files come from anywhere, and so do the names in them. A geometry file is therefore
 * looked for in the model's folder and below only, its size and its number of triangles are
 * bounded, and what the readers do not know ends with a {@link
 * org.mechservice.view.mesh.MeshException} that names file and reason; nothing of the file is run.
 */
@NullMarked
package org.mechservice.view.mesh;

import org.jspecify.annotations.NullMarked;
