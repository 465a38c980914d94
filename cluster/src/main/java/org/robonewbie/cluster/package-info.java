/** Experiments on Apache Spark. Read {@link org.robonewbie.cluster.SparkEngine} first, then docs/cluster.md. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.cluster;
