// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

namespace qvgen::test::sources {

/// An equation as it is printed.
struct Printed {
  std::string number;  ///< "3.7", "table 3.2, row 4"; parts of an equation have the whole one's; rows of a
                       ///< section with a label are numbered by their place: "5.1, line 4"
  std::string latex;
  std::string right;         ///< the whole equation as it should be; empty if it is right as printed
  std::string reading;       ///< what was assumed where print or scan is not plain
  std::string note;          ///< why it is wrong
  std::string definition;    ///< what it defines, for what cannot be right or wrong
  std::string excluded;      ///< why it is not judged
  std::string evidence;      ///< what shows that words or numbers in print are wrong: `right` is words too
  bool local = false;        ///< gives a name of its own to what is on the right
  std::vector<int> indices;  ///< the values of i at which a general equation is judged
};

/// True if its LaTeX is an equation to be judged: no definition, not excluded, no words.
bool is_judged(const Printed& equation);

/// The state in which an example has numbers; positions and rates of turning joints in degrees, as printed.
struct NumbersOfExample {
  std::map<std::string, double> lengths;
  std::vector<double> positions;  ///< empty: the section has no numbers of its own
  std::vector<double> rates;
  double tolerance = 0;  ///< half of the last printed digit, or more where the input was rounded
};

/// Equations about one arm.
struct Section {
  std::string title;
  std::string pages;        ///< of the source, as far as it has or keeps numbers: "22 to 24"
  std::string label;        ///< of rows that have no number: "5.1"
  std::string robot;        ///< one of generator/robots, or
  std::string description;  ///< the text of a description; neither: rotations only
  bool dynamics = false;    ///< what is named is a state of motion, not a pose
  bool frames = false;      ///< frames before a letter belong to its name
  std::string screws = {};  ///< what of the Paden-Kahan document: "arm", "shifted" or "axes"
  bool inverse = false;     ///< the joints' equations are judged at all solutions of a pose
  NumbersOfExample numbers = {};
  std::vector<Printed> equations;
};

struct Chapter {
  std::string title;
  std::string prefix;  ///< of its numbers: "3."
  int count = 0;       ///< numbers run from 1 to this; 0: they have none
  std::vector<Section> sections;
};

/// Reads the folder printed/, in the order of the sources.
std::vector<Chapter> transcriptions();

}  // namespace qvgen::test::sources
