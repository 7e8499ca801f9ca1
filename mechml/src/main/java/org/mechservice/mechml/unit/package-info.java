/** Units of MechML: their dimension and their size in SI. */
@NullMarked
package org.mechservice.mechml.unit;

import org.jspecify.annotations.NullMarked;
