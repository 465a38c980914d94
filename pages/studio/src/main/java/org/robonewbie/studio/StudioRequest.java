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
     * @param context what can be acted upon
     */
    void applyTo(StudioContext context);

    /** The page has drawn its last frame and is ready for the next. */
    record Seen() implements StudioRequest {
        @Override
        public void applyTo(StudioContext context) {}
    }

    /**
     * Asks for the thoughts of one robot only.
     *
     * @param team name of its team
     * @param number its number
     */
    record Watch(String team, int number) implements StudioRequest {
        @Override
        public void applyTo(StudioContext context) {}
    }

    /**
     * Changes a number of a robot's program while it runs.
     *
     * @param wish which number, and its new value
     */
    record Tune(NumberWish wish) implements StudioRequest {
        @Override
        public void applyTo(StudioContext context) {
            context.numbers().put(wish);
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
        public void applyTo(StudioContext context) {
            orders.forEach(context.simulation()::order);
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
        public void applyTo(StudioContext context) {
            context.undoManager().change(name, gesture, () -> orders.forEach(context.simulation()::order));
        }
    }

    /** Takes the last change back, or does it again. */
    enum History implements StudioRequest {
        UNDO {
            @Override
            public void applyTo(StudioContext context) {
                context.undoManager().undo();
            }
        },
        REDO {
            @Override
            public void applyTo(StudioContext context) {
                context.undoManager().redo();
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
        public void applyTo(StudioContext context) {
            PlayerNumber player = context.puppets().add(side, context.now());
            context.undoManager().puppetAdded(player);
        }
    }

    /**
     * Takes a robot away that people steer.
     *
     * @param player the robot
     */
    record RemovePuppet(PlayerNumber player) implements StudioRequest {
        @Override
        public void applyTo(StudioContext context) {
            context.undoManager().removePuppet(player);
        }
    }
}
