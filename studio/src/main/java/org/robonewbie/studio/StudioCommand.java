package org.robonewbie.studio;

import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.monitor.PlayerNumber;

/** What a page can ask for. */
interface StudioCommand {

    /**
     * Does what is asked for.
     *
     * @param stage what can be acted upon
     */
    void applyTo(Stage stage);

    /** The page has drawn its last frame and is ready for the next. */
    record Seen() implements StudioCommand {
        @Override
        public void applyTo(Stage stage) {}
    }

    /**
     * Asks for the thoughts of one robot only.
     *
     * @param team name of its team
     * @param number its number
     */
    record Watch(String team, int number) implements StudioCommand {
        @Override
        public void applyTo(Stage stage) {}
    }

    /** Stops the clock. */
    record Pause() implements StudioCommand {
        @Override
        public void applyTo(Stage stage) {
            stage.simulation().pause();
        }
    }

    /** Lets the clock run. */
    record Resume() implements StudioCommand {
        @Override
        public void applyTo(Stage stage) {
            stage.simulation().resume();
        }
    }

    /**
     * Runs some cycles and pauses.
     *
     * @param cycles how many, at least 1
     */
    record Step(int cycles) implements StudioCommand {
        @Override
        public void applyTo(Stage stage) {
            stage.simulation().step(cycles);
        }
    }

    /**
     * Changes how fast time passes.
     *
     * @param factor simulated seconds per second
     */
    record Speed(double factor) implements StudioCommand {
        @Override
        public void applyTo(Stage stage) {
            stage.simulation().setSpeed(factor);
        }
    }

    /** Puts everything back to the start. */
    record Reset() implements StudioCommand {
        @Override
        public void applyTo(Stage stage) {
            stage.simulation().reset();
        }
    }

    /**
     * Puts the ball somewhere, at rest.
     *
     * @param position its centre in metres
     */
    record PlaceBall(Vector3 position) implements StudioCommand {
        @Override
        public void applyTo(Stage stage) {
            stage.simulation().placeBall(position, Vector3.ZERO);
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
        public void applyTo(Stage stage) {
            stage.simulation().placeRobot(side, number, position, headingDegrees);
        }
    }

    /**
     * Lets a team begin.
     *
     * @param side the team
     */
    record KickOff(TeamSide side) implements StudioCommand {
        @Override
        public void applyTo(Stage stage) {
            stage.simulation().kickOff(side);
        }
    }

    /** Gives the ball free. */
    record DropBall() implements StudioCommand {
        @Override
        public void applyTo(Stage stage) {
            stage.simulation().dropBall();
        }
    }

    /**
     * Sets the play mode.
     *
     * @param mode the new one
     */
    record SetPlayMode(PlayMode mode) implements StudioCommand {
        @Override
        public void applyTo(Stage stage) {
            stage.simulation().setPlayMode(mode);
        }
    }

    /**
     * Brings a robot that people steer.
     *
     * @param side its team; the first robot of all plays on the left
     */
    record AddPuppet(TeamSide side) implements StudioCommand {
        @Override
        public void applyTo(Stage stage) {
            stage.puppets().add(side, stage.now());
        }
    }

    /**
     * Takes a robot away that people steer.
     *
     * @param player the robot
     */
    record RemovePuppet(PlayerNumber player) implements StudioCommand {
        @Override
        public void applyTo(Stage stage) {
            stage.puppets().remove(player);
        }
    }
}
