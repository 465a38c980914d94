package org.robonewbie.simulator.cycle;

import java.util.ArrayList;
import java.util.List;
import org.robonewbie.simulator.landscape.Landscape;
import org.robonewbie.simulator.sensing.CameraSettings;
import org.robonewbie.simulator.soccer.SoccerParameters;

/**
 * All that has an influence on what happens in a world: equal settings and equal agents give equal runs.
 *
 * <pre>{@code
 * WorldSettings settings = WorldSettings.beginner().withSeed(7).withNoise(false);
 * }</pre>
 *
 * @param parameters pitch, rules and noise of beams
 * @param synchronous whether the world waits for the agents; else it runs on the clock
 * @param camera how robots see: noise, and what no camera could know
 * @param landscape what stands on the pitch
 * @param seed start of all random numbers
 */
public record WorldSettings(
        SoccerParameters parameters, boolean synchronous, CameraSettings camera, Landscape landscape, long seed) {

    /**
     * Begins with pitch, rules and noise of the league.
     *
     * @return settings of a world that waits for its agents, with seed 0
     */
    public static WorldSettings league() {
        return of(SoccerParameters.league());
    }

    /**
     * Begins with the beginners' pitch and rules.
     *
     * @return settings of a world that waits for its agents, with seed 0
     */
    public static WorldSettings beginner() {
        return of(SoccerParameters.beginner());
    }

    private static WorldSettings of(SoccerParameters parameters) {
        return new WorldSettings(parameters, true, CameraSettings.STANDARD, Landscape.SOCCER, 0);
    }

    /**
     * Changes pitch and rules.
     *
     * @param value the new ones
     * @return the same settings otherwise
     */
    public WorldSettings withParameters(SoccerParameters value) {
        return new WorldSettings(value, synchronous, camera, landscape, seed);
    }

    /**
     * Chooses between waiting for agents and running on the clock.
     *
     * @param value whether the world waits
     * @return the same settings otherwise
     */
    public WorldSettings withSynchronous(boolean value) {
        return new WorldSettings(parameters, value, camera, landscape, seed);
    }

    /**
     * Changes how robots see.
     *
     * @param value the new settings of all cameras
     * @return the same settings otherwise
     */
    public WorldSettings withCamera(CameraSettings value) {
        return new WorldSettings(parameters, synchronous, value, landscape, seed);
    }

    /**
     * Switches the noise of cameras.
     *
     * @param on whether robots see with noise
     * @return the same settings otherwise
     */
    public WorldSettings withNoise(boolean on) {
        return withCamera(camera.withNoise(on));
    }

    /**
     * Changes what stands on the pitch.
     *
     * @param value the new landscape
     * @return the same settings otherwise
     */
    public WorldSettings withLandscape(Landscape value) {
        return new WorldSettings(parameters, synchronous, camera, value, seed);
    }

    /**
     * Changes the seed.
     *
     * @param value start of all random numbers
     * @return the same settings otherwise
     */
    public WorldSettings withSeed(long value) {
        return new WorldSettings(parameters, synchronous, camera, landscape, value);
    }

    /** {@return the settings as lines of the form {@code name=value}, as recordings begin with them} */
    public List<String> description() {
        List<String> lines = new ArrayList<>();
        lines.add("seed=" + seed);
        lines.add("synchronous=" + synchronous);
        lines.add("noise=" + camera.noise());
        lines.add("truth=" + camera.ownPosition() + "," + camera.ownOrientation() + "," + camera.ballPosition());
        lines.add("physics=fast"); // recordings of former versions may say "exact" here
        if (!landscape.isBare()) {
            lines.add("scene=" + landscape.name());
        }
        lines.addAll(parameters.assignments());
        return lines;
    }
}
