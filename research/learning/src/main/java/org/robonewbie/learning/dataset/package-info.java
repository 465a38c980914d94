/**
 * Data sets: what robots have felt and done in many runs, and what was true, as tables for other programs. Read {@link
 * org.robonewbie.learning.dataset.DataSet} first, then docs/datasets.md.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.learning.dataset;
