/** Self-contained pages: HTML, SVG diagrams, tables, a recommendation in words. */
@NullMarked
package org.mechservice.report.page;

import org.jspecify.annotations.NullMarked;
