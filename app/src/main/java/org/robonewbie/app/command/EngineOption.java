package org.robonewbie.app.command;

import java.util.ServiceLoader;
import org.robonewbie.learning.series.ExperimentEngine;
import org.robonewbie.learning.series.LocalEngine;
import org.robonewbie.programs.CalledWronglyException;
import picocli.CommandLine.Option;

/** Where trials are carried out: on the cores of this computer, or on a cluster. */
final class EngineOption {

    private static final String LOCAL = "local";

    @Option(
            names = "--engine",
            paramLabel = "NAME",
            defaultValue = LOCAL,
            description = "local or spark (default: local).")
    private String engine = LOCAL;

    @Option(
            names = "--master",
            paramLabel = "URL",
            defaultValue = "",
            description = "spark: where the cluster is, such as spark://host:7077 or local-cluster[2,1,1024].")
    private String master = "";

    @Option(names = "--threads", paramLabel = "N", description = "local: how many threads (default: one per core).")
    private int threads = Runtime.getRuntime().availableProcessors();

    /** {@return whether trials are carried out in this program} */
    boolean isLocal() {
        return engine.equals(LOCAL);
    }

    /** {@return the trials at the same time in this program} */
    int threads() {
        if (threads < 1) {
            throw new CalledWronglyException("--threads " + threads + ": give a number of at least 1.");
        }
        return threads;
    }

    /** {@return where the cluster is, in the engine's own notation; empty for its usual place} */
    String master() {
        return master;
    }

    /** {@return the engine that was chosen} */
    ExperimentEngine engine() {
        if (isLocal()) {
            return new LocalEngine(threads());
        }
        return ServiceLoader.load(ExperimentEngine.class).stream()
                .map(ServiceLoader.Provider::get)
                .filter(other -> other.label().equals(engine))
                .findFirst()
                .orElseThrow(() -> new CalledWronglyException("There is no engine \"" + engine
                        + "\" in this program. There is local; spark needs the program of docs/cluster.md."));
    }
}
