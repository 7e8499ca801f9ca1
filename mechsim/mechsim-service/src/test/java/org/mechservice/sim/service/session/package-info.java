@NullMarked
package org.mechservice.sim.service.session;

import org.jspecify.annotations.NullMarked;
