package org.robonewbie.studio;

import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.simulator.SimulationControl;

/** What a page can ask for. */
sealed interface StudioCommand {

    /**
     * Does what is asked for.
     *
     * @param simulation the running simulation
     */
    void applyTo(SimulationControl simulation);

    /** The page has drawn its last frame and is ready for the next. */
    record Seen() implements StudioCommand {
        @Override
        public void applyTo(SimulationControl simulation) {}
    }

    /**
     * Asks for the thoughts of one robot only.
     *
     * @param team name of its team
     * @param number its number
     */
    record Watch(String team, int number) implements StudioCommand {
        @Override
        public void applyTo(SimulationControl simulation) {}
    }

    /** Stops the clock. */
    record Pause() implements StudioCommand {
        @Override
        public void applyTo(SimulationControl simulation) {
            simulation.pause();
        }
    }

    /** Lets the clock run. */
    record Resume() implements StudioCommand {
        @Override
        public void applyTo(SimulationControl simulation) {
            simulation.resume();
        }
    }

    /**
     * Runs some cycles and pauses.
     *
     * @param cycles how many, at least 1
     */
    record Step(int cycles) implements StudioCommand {
        @Override
        public void applyTo(SimulationControl simulation) {
            simulation.step(cycles);
        }
    }

    /**
     * Changes how fast time passes.
     *
     * @param factor simulated seconds per second
     */
    record Speed(double factor) implements StudioCommand {
        @Override
        public void applyTo(SimulationControl simulation) {
            simulation.setSpeed(factor);
        }
    }

    /** Puts everything back to the start. */
    record Reset() implements StudioCommand {
        @Override
        public void applyTo(SimulationControl simulation) {
            simulation.reset();
        }
    }

    /**
     * Puts the ball somewhere, at rest.
     *
     * @param position its centre in metres
     */
    record PlaceBall(Vector3 position) implements StudioCommand {
        @Override
        public void applyTo(SimulationControl simulation) {
            simulation.placeBall(position, Vector3.ZERO);
        }
    }

    /**
     * Puts a robot somewhere.
     *
     * @param side its team
     * @param number its number
     * @param position centre of its torso in metres
     * @param headingDegrees where it looks
     */
    record PlaceRobot(TeamSide side, int number, Vector3 position, double headingDegrees) implements StudioCommand {
        @Override
        public void applyTo(SimulationControl simulation) {
            simulation.placeRobot(side, number, position, headingDegrees);
        }
    }

    /**
     * Lets a team begin.
     *
     * @param side the team
     */
    record KickOff(TeamSide side) implements StudioCommand {
        @Override
        public void applyTo(SimulationControl simulation) {
            simulation.kickOff(side);
        }
    }

    /** Gives the ball free. */
    record DropBall() implements StudioCommand {
        @Override
        public void applyTo(SimulationControl simulation) {
            simulation.dropBall();
        }
    }

    /**
     * Sets the play mode.
     *
     * @param mode the new one
     */
    record SetPlayMode(PlayMode mode) implements StudioCommand {
        @Override
        public void applyTo(SimulationControl simulation) {
            simulation.setPlayMode(mode);
        }
    }
}
