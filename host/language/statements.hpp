// The statements of the language: each reads the rest of its line into the script.
#pragma once

#include "language/cursor.hpp"
#include "language/script.hpp"

#include <optional>
#include <string_view>

namespace pelage::language {

void parse_define(Script&, Cursor&);       // define.cpp
void parse_parameter(Script&, Cursor&);    // parameters.cpp: what follows `define parameter`
void parse_place_field(Script&, Cursor&);  // field.cpp: what follows `define field`
void parse_use(Script&, Cursor&);          // use.cpp
void parse_create(Script&, Cursor&);       // create.cpp
void parse_set(Script&, Cursor&);          // set.cpp
void parse_rule(Script&, Cursor&);         // rule.cpp
void parse_phase(Script&, Cursor&);        // run.cpp
void parse_snap(Script&, Cursor&);         // run.cpp
void parse_stop(Script&, Cursor&);         // run.cpp
void parse_colormap(Script&, Cursor&);     // output.cpp
void parse_output(Script&, Cursor&);       // output.cpp
void parse_texture(Script&, Cursor&);      // output.cpp
void parse_zoom(Script&, Cursor&);         // output.cpp

// ---- pieces that several statements share

Action parse_action(Script&, Cursor&, const Condition&);         // action.cpp
Action parse_react(Script&, Cursor&);                            // react.cpp
Action parse_aggregate(Script&, Cursor&);                        // aggregate.cpp
bool is_neural(Cursor);                                          // neural.cpp: `neural "MODEL"` comes in this line
Action parse_neural(Script&, Cursor&);                           // neural.cpp
Operand parse_operand(Script&, Cursor&, std::string_view what);  // operand.cpp
// What an expression may read depends on where it stands.
enum class Scope { rule, field, start, picture };
// Throws Error unless an expression comes next; it may be a number or a name alone.
Expression parse_expression(Script&, Cursor&, Scope, std::string_view what);  // operand.cpp
// Takes it into Experiment::expressions and gives its place there.
std::size_t keep_expression(Script&, const Cursor&, const Token& at, Expression);  // operand.cpp

// VALUE [dev DEVIATION], or an expression
Spread parse_start_value(Script&, Cursor&, std::string_view what);  // use.cpp
// VALUE [dev DEVIATION]
Spread parse_spread(Cursor&, std::string_view what);  // use.cpp
std::optional<Spread> parse_degrees(Cursor&);         // none | VALUE [dev DEVIATION]; use.cpp
double parse_deviation(Cursor&);                      // [dev DEVIATION], else 0; use.cpp

// Throws Error unless `name` can name something new; `what` is "chemical", "mapping", "parameter" or "field".
void check_name(const Script&, const Cursor&, const Token& name, std::string_view what);  // operand.cpp

// The CSS name (any case) or RRGGBB of a colour; empty when it is none.
std::optional<Colour> find_colour(std::string_view);  // colours.cpp
Colour parse_colour(const Cursor&, const Token&);     // colours.cpp
// heat | gradient | ... | "STOP at F, STOP at F" ...
ColormapChoice parse_colormap_choice(Cursor&, bool stops);  // output.cpp

}  // namespace pelage::language
