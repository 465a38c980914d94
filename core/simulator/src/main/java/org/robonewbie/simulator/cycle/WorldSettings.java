package org.robonewbie.simulator.cycle;

import java.util.ArrayList;
import java.util.List;
import org.robonewbie.simulator.landscape.Landscape;
import org.robonewbie.simulator.sensing.CameraSettings;
import org.robonewbie.simulator.soccer.SoccerParameters;

/**
 * The parameters that determine a run: identical settings and identical agents produce identical runs.
 *
 * <pre>{@code
 * WorldSettings settings = WorldSettings.beginner().withSeed(7).withNoise(false);
 * }</pre>
 *
 * @param parameters pitch, rules and beam noise
 * @param synchronous whether each cycle waits for all agents; otherwise the simulation runs in real time
 * @param camera camera noise and ground truth in camera images
 * @param landscape objects on the pitch
 * @param seed seed for all random numbers
 */
public record WorldSettings(
        SoccerParameters parameters, boolean synchronous, CameraSettings camera, Landscape landscape, long seed) {

    /**
     * Returns the settings of the league.
     *
     * @return synchronous settings with the league's pitch, rules and noise, and with seed 0
     */
    public static WorldSettings league() {
        return of(SoccerParameters.league());
    }

    /**
     * Returns the settings for beginners.
     *
     * @return synchronous settings with the beginners' pitch and rules, and with seed 0
     */
    public static WorldSettings beginner() {
        return of(SoccerParameters.beginner());
    }

    private static WorldSettings of(SoccerParameters parameters) {
        return new WorldSettings(parameters, true, CameraSettings.STANDARD, Landscape.SOCCER, 0);
    }

    /**
     * Changes the pitch and the rules.
     *
     * @param value the new parameters
     * @return a modified copy
     */
    public WorldSettings withParameters(SoccerParameters value) {
        return new WorldSettings(value, synchronous, camera, landscape, seed);
    }

    /**
     * Selects sync mode or real time.
     *
     * @param value whether each cycle waits for all agents
     * @return a modified copy
     */
    public WorldSettings withSynchronous(boolean value) {
        return new WorldSettings(parameters, value, camera, landscape, seed);
    }

    /**
     * Changes the cameras.
     *
     * @param value settings of all cameras
     * @return a modified copy
     */
    public WorldSettings withCamera(CameraSettings value) {
        return new WorldSettings(parameters, synchronous, value, landscape, seed);
    }

    /**
     * Switches camera noise on or off.
     *
     * @param on whether camera readings are noisy
     * @return a modified copy
     */
    public WorldSettings withNoise(boolean on) {
        return withCamera(camera.withNoise(on));
    }

    /**
     * Changes the objects on the pitch.
     *
     * @param value the new landscape
     * @return a modified copy
     */
    public WorldSettings withLandscape(Landscape value) {
        return new WorldSettings(parameters, synchronous, camera, value, seed);
    }

    /**
     * Changes the seed.
     *
     * @param value seed for all random numbers
     * @return a modified copy
     */
    public WorldSettings withSeed(long value) {
        return new WorldSettings(parameters, synchronous, camera, landscape, value);
    }

    /** {@return the settings as {@code name=value} lines for the header of a recording} */
    public List<String> description() {
        List<String> lines = new ArrayList<>();
        lines.add("seed=" + seed);
        lines.add("synchronous=" + synchronous);
        lines.add("noise=" + camera.noise());
        lines.add("truth=" + camera.ownPosition() + "," + camera.ownOrientation() + "," + camera.ballPosition());
        lines.add("physics=fast"); // "exact" in some recordings of earlier versions
        if (!landscape.isBare()) {
            lines.add("scene=" + landscape.name());
        }
        lines.addAll(parameters.assignments());
        return lines;
    }
}
