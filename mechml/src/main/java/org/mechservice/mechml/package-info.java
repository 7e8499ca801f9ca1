/** MechML text to a checked, immutable mechanism with the settings of its simulation. */
@NullMarked
package org.mechservice.mechml;

import org.jspecify.annotations.NullMarked;
