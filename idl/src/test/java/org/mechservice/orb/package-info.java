@NullMarked
package org.mechservice.orb;

import org.jspecify.annotations.NullMarked;
