package org.mechservice.study.run;

import org.mechservice.mechml.document.Element;
import org.mechservice.study.design.Spread;

/**
 * A factor with its values.
 *
 * @param element that gives it, a factor or a table
 */
record GivenFactor(Element element, StudyFactor factor, Spread spread) {}
