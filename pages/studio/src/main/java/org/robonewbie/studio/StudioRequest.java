package org.robonewbie.studio;

import java.util.List;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.protocol.order.PlayerNumber;
import org.robonewbie.protocol.telemetry.NumberWish;

/** What a page can ask for. */
interface StudioRequest {

    /**
     * Does what is asked for.
     *
     * @param stage what can be acted upon
     */
    void applyTo(Stage stage);

    /** The page has drawn its last frame and is ready for the next. */
    record Seen() implements StudioRequest {
        @Override
        public void applyTo(Stage stage) {}
    }

    /**
     * Asks for the thoughts of one robot only.
     *
     * @param team name of its team
     * @param number its number
     */
    record Watch(String team, int number) implements StudioRequest {
        @Override
        public void applyTo(Stage stage) {}
    }

    /**
     * Changes a number of a robot's program while it runs.
     *
     * @param wish which number, and its new value
     */
    record Tune(NumberWish wish) implements StudioRequest {
        @Override
        public void applyTo(Stage stage) {
            stage.numbers().put(wish);
        }
    }

    /**
     * Gives orders to the clock of the world.
     *
     * @param orders the orders, carried out in this order
     */
    record Orders(List<Order> orders) implements StudioRequest {

        Orders(Order... orders) {
            this(List.of(orders));
        }

        @Override
        public void applyTo(Stage stage) {
            orders.forEach(stage.simulation()::order);
        }
    }

    /**
     * Changes the world, which can be undone.
     *
     * @param name what is done, such as "ball moved"
     * @param gesture number of the drag that it belongs to, 0 if it is none
     * @param orders the orders, carried out in this order
     */
    record Change(String name, long gesture, List<Order> orders) implements StudioRequest {

        Change(String name, Order... orders) {
            this(name, 0, List.of(orders));
        }

        @Override
        public void applyTo(Stage stage) {
            stage.deeds().change(name, gesture, () -> orders.forEach(stage.simulation()::order));
        }
    }

    /** Takes the last change back, or does it again. */
    enum History implements StudioRequest {
        UNDO {
            @Override
            public void applyTo(Stage stage) {
                stage.deeds().undo();
            }
        },
        REDO {
            @Override
            public void applyTo(Stage stage) {
                stage.deeds().redo();
            }
        }
    }

    /**
     * Adds a robot that is steered by hand.
     *
     * @param side its team; the first robot of all plays on the left
     */
    record AddPuppet(TeamSide side) implements StudioRequest {
        @Override
        public void applyTo(Stage stage) {
            PlayerNumber player = stage.puppets().add(side, stage.now());
            stage.deeds().puppetAdded(player);
        }
    }

    /**
     * Takes a robot away that people steer.
     *
     * @param player the robot
     */
    record RemovePuppet(PlayerNumber player) implements StudioRequest {
        @Override
        public void applyTo(Stage stage) {
            stage.deeds().removePuppet(player);
        }
    }
}
