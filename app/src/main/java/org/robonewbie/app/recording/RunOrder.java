package org.robonewbie.app.recording;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.robonewbie.nao.Cycle;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.server.SimulatorSettings;

/**
 * What is recorded: the same program again and again, with another seed each time.
 *
 * @param agentAndOptions what the program is called, and the options that it gets
 * @param robots how many robots it brings
 * @param seconds simulated length of each run
 * @param firstSeed seed of the first run; each run has one more than the run before
 */
public record RunOrder(List<String> agentAndOptions, int robots, double seconds, long firstSeed) {

    /** Copies the list. */
    public RunOrder {
        agentAndOptions = List.copyOf(agentAndOptions);
    }

    /** {@return what the program is called} */
    public String agent() {
        return agentAndOptions.get(0);
    }

    /**
     * Returns what a data set tells about how it was made.
     *
     * @param version the version of RoboNewbie
     * @return names and values
     */
    public Map<String, String> facts(String version) {
        Map<String, String> facts = new LinkedHashMap<>();
        facts.put("version", version);
        facts.put("agent", String.join(" ", agentAndOptions));
        facts.put("seconds", Double.toString(seconds));
        facts.put("first seed", Long.toString(firstSeed));
        facts.put("robots", Integer.toString(robots));
        facts.put("pitch", "beginner");
        return facts;
    }

    /** The seed of a run, of which the first one is 1. */
    long seed(int run) {
        return firstSeed + run - 1;
    }

    /** The number of cycles after which a run is over. */
    long cycles() {
        return Math.round(seconds / Cycle.SECONDS);
    }

    SimulatorSettings settings(int run) {
        return SimulatorSettings.of(WorldSettings.beginner().withSeed(seed(run)))
                .withAgentPort(0)
                .withSpeed(SimulationControl.AS_FAST_AS_POSSIBLE)
                .withAwaitedAgents(robots)
                .withSeconds(seconds);
    }
}
